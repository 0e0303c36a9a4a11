#include "graze/base/linalg/detail/periodic_schur.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/periodic_hessenberg.hpp"

namespace graze {
namespace {

using Eigen::Index;
using ComplexPair = Eigen::Matrix2cd;
using ComplexFactors = std::vector<Eigen::MatrixXcd>;

// The 2 x 2 diagonal block at row j of the product of the triangular factors, up to a positive
// scale.
ComplexPair triangular_block(const ComplexFactors& factors, Index j) {
  ComplexPair product = ComplexPair::Identity();
  for (std::size_t i = 1; i < factors.size(); ++i) {
    product = (factors[i].block<2, 2>(j, j) * product).eval();
    const double size = product.cwiseAbs().maxCoeff();
    if (size > 0.0) product /= size;
  }
  return product;
}

// The same of all factors, the triangular ones having the product r; entries of at most 1.
ComplexPair whole_block(const ComplexFactors& factors, Index j, const ComplexPair& r) {
  const ComplexPair product = factors[0].block<2, 2>(j, j) * r;
  const double size = product.cwiseAbs().maxCoeff();
  return size > 0.0 ? ComplexPair(product / size) : product;
}

// Whether a real 2 x 2 matrix of entries up to 1 has a conjugate pair of eigenvalues, beyond
// rounding.
bool has_pair(const ComplexPair& p, double rounding) {
  const double half = 0.5 * (p(0, 0).real() - p(1, 1).real());
  return half * half + p(0, 1).real() * p(1, 0).real() < -rounding;
}

// The eigenvalue of a 2 x 2 matrix that shall come last. Of a real pair of clearly different sizes
// it is the smaller one: a factor then has its own small entries last too, and what becomes small
// in the product becomes small in the first factor. Otherwise the one nearer to the last entry,
// which stays the same from step to step. Where rounding has made a double eigenvalue complex, its
// real part.
Complex shift_of(const ComplexPair& p, bool pair) {
  const Complex mean = 0.5 * (p(0, 0) + p(1, 1)), half = 0.5 * (p(0, 0) - p(1, 1));
  Complex square = half * half + p(0, 1) * p(1, 0);
  if (!pair && square.real() < 0.0) square = 0.0;
  const Complex root = std::sqrt(square);
  const double plus = std::abs(mean + root), minus = std::abs(mean - root);
  if (!pair && 2.0 * plus < minus) return mean + root;
  if (!pair && 2.0 * minus < plus) return mean - root;
  return std::abs(half + root) < std::abs(half - root) ? mean + root : mean - root;
}

// The unitary matrix whose first column is (a, b) normalised; real for real a, b.
ComplexPair rotation(Complex a, Complex b) {
  const double size = std::max(std::abs(a), std::abs(b));
  if (!(size > 0.0)) return ComplexPair::Identity();
  a /= size;
  b /= size;
  const double length = std::sqrt(std::norm(a) + std::norm(b));
  ComplexPair g;
  g << a / length, -std::conj(b) / length, b / length, std::conj(a) / length;
  return g;
}

// One step of the periodic QR iteration on rows j, j + 1, over all columns and rows.
void step(ComplexFactors& factors, Index j, ComplexPair g) {
  const Index n = factors[0].rows(), k = static_cast<Index>(factors.size());
  // The change of basis g in the image of the first factor, then triangular again around the cycle.
  auto image = factors[0].middleRows(j, 2).rightCols(n - j);
  image = (g.adjoint() * image).eval();
  for (Index i = 1; i <= k; ++i) {
    Eigen::MatrixXcd& factor = factors[static_cast<std::size_t>(i % k)];
    auto domain = factor.middleCols(j, 2).topRows(j + 2);
    domain = (domain * g).eval();
    if (i == k) break;
    g = rotation(factor(j, j), factor(j + 1, j));
    auto rows = factor.middleRows(j, 2).rightCols(n - j);
    rows = (g.adjoint() * rows).eval();
    factor(j + 1, j) = 0.0;
  }
}

// The basis with which a step starts in the image of the first factor.
ComplexPair start_of(const ComplexFactors& factors, Index j, const ComplexPair& r,
                     const ComplexPair& p, bool pair) {
  // With its first column negligible the triangular product hides the block's smaller eigenvalue,
  // and a shift would leave the block as it is; without one the step moves it to the end.
  const bool hidden =
      std::abs(r(0, 0)) <= kEpsilon * std::max(std::abs(r(0, 1)), std::abs(r(1, 1))) &&
      std::abs(p(1, 0)) <= kEpsilon * (std::abs(p(0, 0)) + std::abs(p(1, 1)));
  if (hidden) return rotation(factors[0](j, j), factors[0](j + 1, j));
  return rotation(p(0, 0) - shift_of(p, pair), p(1, 0));
}

// Triangularises the block at rows j, j + 1 of the first factor; `pair` says what its eigenvalues
// are. False when it does not get there.
bool triangularise(ComplexFactors& factors, Index j, bool& pair) {
  // Every factor rounds its product with the others to eps, twice per entry.
  const double rounding = 8.0 * kEpsilon * static_cast<double>(factors.size());
  for (int steps = 0; steps < 30; ++steps) {
    Eigen::MatrixXcd& h = factors[0];
    double size = std::abs(h(j, j)) + std::abs(h(j + 1, j + 1));
    if (size == 0.0) size = std::abs(h(j, j + 1));
    if (std::abs(h(j + 1, j)) <= kEpsilon * size) {
      h(j + 1, j) = 0.0;
      return true;
    }
    const ComplexPair r = triangular_block(factors, j), p = whole_block(factors, j, r);
    // A pair within rounding of real eigenvalues shows when real shifts do not converge.
    if (steps == 0) pair = has_pair(p, rounding);
    if (!pair && steps >= 10) pair = has_pair(p, 0.0);
    step(factors, j, start_of(factors, j, r, p, pair));
  }
  return false;
}

}  // namespace

std::optional<PeriodicSchurForm> periodic_schur(std::vector<Matrix> factors) {
  PeriodicHessenberg reduction(std::move(factors));
  if (!reduction.reduce()) return {};
  PeriodicSchurForm form;
  for (const Matrix& factor : reduction.factors()) form.factors.push_back(factor.cast<Complex>());
  for (const Index row : reduction.blocks()) {
    bool pair = false;
    if (!triangularise(form.factors, row, pair)) return {};
    if (pair) form.pairs.push_back(row);
  }
  std::sort(form.pairs.begin(), form.pairs.end());
  return form;
}

}  // namespace graze
