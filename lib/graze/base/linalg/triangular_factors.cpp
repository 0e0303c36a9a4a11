#include "graze/base/linalg/detail/triangular_factors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "graze/base/detail/scaled.hpp"
#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Solves a_i z_i - t_i z_{i+1} = -g_i, i = 0..k-1, z_k = z_0, with row interchanges; false when it
// is singular and the right-hand side does not fit. z_i is free, and then 0, where it only appears
// with the factor 0.
class CyclicBidiagonal {
 public:
  explicit CyclicBidiagonal(Index k) : rows_(static_cast<std::size_t>(k)) {}

  template <class A, class T>
  bool solve(const A& a, const T& t, const ComplexVector& g, ComplexVector& z) {
    const Index k = g.size();
    // The row carried along: p z_0 + q z_i = r.
    Row carry{a(0), -t(0), 0.0, -g[0]};
    for (Index i = 1; i < k; ++i) {
      Row& kept = rows_[static_cast<std::size_t>(i)];
      const Complex ai = a(i), ti = t(i);
      if (std::norm(carry.q) >= std::norm(ai)) {
        kept = carry;
        const Complex m = carry.q == 0.0 ? 0.0 : ai / carry.q;
        carry = {-m * kept.p, -ti, 0.0, -g[i] - m * kept.r};
      } else {
        kept = {0.0, ai, -ti, -g[i]};
        const Complex m = carry.q / ai;
        carry = {carry.p, m * ti, 0.0, carry.r + m * g[i]};
      }
    }
    if (!divide(carry.r, carry.p + carry.q, z[0])) return false;
    for (Index i = k - 1; i > 0; --i) {
      const Row& row = rows_[static_cast<std::size_t>(i)];
      if (!divide(row.r - row.p * z[0] - row.w * z[i + 1 == k ? 0 : i + 1], row.q, z[i]))
        return false;
    }
    return true;
  }

 private:
  struct Row {
    Complex p, q, w, r;  // p z_0 + q z_i + w z_{i+1} = r
  };
  static bool divide(Complex above, Complex below, Complex& ratio) {
    if (below == 0.0 && above != 0.0) return false;
    ratio = below == 0.0 ? 0.0 : above / below;
    return std::isfinite(ratio.real()) && std::isfinite(ratio.imag());
  }
  std::vector<Row> rows_;
};

// The vectors x_i of eigenvalue j, column i of x; false where there are none.
bool right_vectors(const TriangularFactors& factors, Index j, Eigen::MatrixXcd& x) {
  const Index n = factors[0].rows(), k = static_cast<Index>(factors.size());
  const auto at = [&factors](Index i) -> const Eigen::MatrixXcd& {
    return factors[static_cast<std::size_t>(i)];
  };
  x.setZero(n, k);
  x.row(j).setOnes();
  ComplexVector g(k), z(k);
  CyclicBidiagonal system(k);
  for (Index l = j - 1; l >= 0; --l) {
    for (Index i = 0; i < k; ++i)
      g[i] = (at(i).row(l).segment(l + 1, j - l) * x.col(i).segment(l + 1, j - l)).value();
    if (!system.solve([&](Index i) { return at(i)(l, l); }, [&](Index i) { return at(i)(j, j); }, g,
                      z))
      return false;
    x.row(l) = z.transpose();
  }
  return true;
}

// The factors in opposite order, transposed and read from the last row and column. The factor from
// space i to i + 1 goes from mirrored space k - 1 - i to k - i.
TriangularFactors mirrored(const TriangularFactors& factors) {
  TriangularFactors mirror;
  for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor)
    mirror.push_back(factor->transpose().reverse());
  return mirror;
}

// The vectors y_i of eigenvalue j, column i of y, from the factors mirrored; false where there are
// none.
bool left_vectors(const TriangularFactors& mirror, Index j, Eigen::MatrixXcd& y) {
  Eigen::MatrixXcd x;
  const Index n = mirror[0].rows(), k = static_cast<Index>(mirror.size());
  if (!right_vectors(mirror, n - 1 - j, x)) return false;
  y.resize(n, k);
  for (Index i = 0; i < k; ++i) y.col(i) = x.col((k - i) % k).reverse();
  return true;
}

// An upper bound on the spectral norm.
double norm_bound(const Eigen::MatrixXcd& matrix) {
  const double rows = matrix.cwiseAbs().rowwise().sum().maxCoeff();
  const double columns = matrix.cwiseAbs().colwise().sum().maxCoeff();
  return std::min(matrix.stableNorm(), std::sqrt(rows) * std::sqrt(columns));
}

// Bounds on the spectral norms of the factors, perturbed, on the spaces of the marked eigenvalues;
// empty where one that is not marked has no vectors.
std::vector<double> joint_norms(const TriangularFactors& factors, double roundings,
                                const std::vector<bool>& marked) {
  const Index n = factors[0].rows();
  const std::size_t k = factors.size();
  const Index apart = std::count(marked.begin(), marked.end(), false);
  const TriangularFactors mirror = mirrored(factors);
  // In space i, the vectors of all that are not marked.
  std::vector<Eigen::MatrixXcd> right(k, Eigen::MatrixXcd(n, apart)), left = right;
  Eigen::MatrixXcd x, y;
  std::vector<Index> rows;
  for (Index j = 0; j < n; ++j) {
    if (marked[static_cast<std::size_t>(j)]) continue;
    if (!right_vectors(factors, j, x) || !left_vectors(mirror, j, y)) return {};
    const Index column = static_cast<Index>(rows.size());
    for (std::size_t i = 0; i < k; ++i) {
      right[i].col(column) = x.col(static_cast<Index>(i));
      left[i].col(column) = y.col(static_cast<Index>(i));
    }
    rows.push_back(j);
  }
  std::vector<double> norms;
  for (std::size_t i = 0; i < k; ++i) {
    const std::size_t next = (i + 1) % k;
    ComplexVector t(apart);
    for (Index c = 0; c < apart; ++c)
      t[c] = factors[i](rows[static_cast<std::size_t>(c)], rows[static_cast<std::size_t>(c)]);
    const Eigen::MatrixXcd rest = factors[i] - right[next] * t.asDiagonal() * left[i].transpose();
    const Eigen::MatrixXcd projector =
        Eigen::MatrixXcd::Identity(n, n) - right[next] * left[next].transpose();
    const double sums = (right[next].colwise().norm().array() * t.transpose().array().abs() *
                         left[i].colwise().norm().array())
                            .sum();
    const double size = factors[i].norm();
    // Beside the perturbation, the rounding of the projection.
    const double of_projection = static_cast<double>(n) * (size + sums);
    norms.push_back(norm_bound(rest) +
                    kEpsilon * (norm_bound(projector) * roundings * size + of_projection));
  }
  return norms;
}

}  // namespace

VectorNorms vector_norms(const TriangularFactors& factors) {
  const Index n = factors[0].rows(), k = static_cast<Index>(factors.size());
  const TriangularFactors mirror = mirrored(factors);
  VectorNorms norms{Matrix::Constant(k, n, kInfinity), Matrix::Constant(k, n, kInfinity)};
  Eigen::MatrixXcd vectors;
  for (Index j = 0; j < n; ++j) {
    if (StopScope::is_over()) break;
    if (right_vectors(factors, j, vectors))
      for (Index i = 0; i < k; ++i) norms.right(i, j) = vectors.col(i).stableNorm();
    if (left_vectors(mirror, j, vectors))
      for (Index i = 0; i < k; ++i) norms.left(i, j) = vectors.col(i).stableNorm();
  }
  return norms;
}

void bound_together(const TriangularFactors& factors, double roundings, long exponent,
                    std::vector<Eigenvalue>& list) {
  double largest = -1.0;
  for (const Eigenvalue& value : list)
    if (!(value.error <= std::abs(value.value))) largest = std::max(largest, std::abs(value.value));
  std::vector<bool> marked;
  for (const Eigenvalue& value : list) marked.push_back(std::abs(value.value) <= largest);
  // A single one has vectors, with the same bound.
  if (std::count(marked.begin(), marked.end(), true) < 2) return;
  const std::vector<double> norms = joint_norms(factors, roundings, marked);
  if (norms.empty()) return;
  Scaled<double> radius{1.0, exponent};
  for (const double norm : norms) radius.times(norm);
  for (std::size_t j = 0; j < list.size(); ++j)
    if (marked[j])
      list[j].error = std::fmin(list[j].error, std::abs(list[j].value) + radius.value());
}

}  // namespace graze
