#include "graze/base/linalg/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/linalg/detail/triangular_factors.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

using Eigen::Index;

// The eigenvalues along the diagonal of a quasi-triangular matrix.
std::vector<Complex> diagonal_values(const Matrix& t) {
  const Index n = t.rows();
  std::vector<Complex> values;
  values.reserve(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) {
    if (i == n - 1 || t(i + 1, i) == 0.0) {
      values.emplace_back(t(i, i));
      continue;
    }
    const double half = 0.5 * (t(i, i) - t(i + 1, i + 1));
    const double below = t(i + 1, i), above = t(i, i + 1);
    const double size = std::max({std::abs(half), std::abs(below), std::abs(above)});
    const double h = half / size;
    const double turn = size * std::sqrt(std::abs(h * h + (below / size) * (above / size)));
    values.emplace_back(t(i + 1, i + 1) + half, turn);
    values.emplace_back(t(i + 1, i + 1) + half, -turn);
    ++i;
  }
  return values;
}

// A unitary change of basis that makes a quasi-triangular matrix triangular, its eigenvalues in
// this order along the diagonal.
void triangularise(Eigen::MatrixXcd& t, const std::vector<Complex>& values) {
  const Index n = t.rows();
  for (Index i = 0; i + 1 < n; ++i) {
    if (t(i + 1, i) == 0.0) continue;
    // (l - t22, t21) is an eigenvector of the block.
    const Complex first = values[static_cast<std::size_t>(i)] - t(i + 1, i + 1);
    const Complex second = t(i + 1, i);
    const double length = std::sqrt(std::norm(first) + std::norm(second));
    const Complex c = first / length, s = second / length;
    for (Index j = i; j < n; ++j) {
      const Complex a = t(i, j), b = t(i + 1, j);
      t(i, j) = times(std::conj(c), a) + times(std::conj(s), b);
      t(i + 1, j) = times(c, b) - times(s, a);
    }
    for (Index k = 0; k < i + 2; ++k) {
      const Complex a = t(k, i), b = t(k, i + 1);
      t(k, i) = times(c, a) + times(s, b);
      t(k, i + 1) = times(std::conj(c), b) - times(std::conj(s), a);
    }
    t(i + 1, i) = 0.0;
  }
}

// Condition number |x| |y| of the j-th eigenvalue of a triangular matrix, x and y its right and
// left vectors with y^* x = 1; not finite where there is no such pair.
double condition_of(const Eigen::MatrixXcd& t, Index j, ComplexVector& x) {
  const Index n = t.rows();
  const Complex value = t(j, j);
  double right = 1.0, left = 1.0;
  x[j] = 1.0;
  for (Index l = j - 1; l >= 0; --l) {
    Complex sum = 0.0;
    for (Index m = l + 1; m <= j; ++m) sum += times(t(l, m), x[m]);
    x[l] = sum / (value - t(l, l));
    right += std::norm(x[l]);
  }
  for (Index l = j + 1; l < n; ++l) {
    Complex sum = 0.0;
    for (Index m = j; m < l; ++m) sum += times(x[m], t(m, l));
    x[l] = sum / (value - t(l, l));
    left += std::norm(x[l]);
  }
  return std::sqrt(right) * std::sqrt(left);
}

// Largest backward error of eigenvectors that is accepted, in units of n eps |A|; a few are usual.
constexpr double kRoundingsOfModes = 64.0;

}  // namespace

double condition_number(const Matrix& matrix) {
  const Vector sigma = right_singular_vectors(matrix).values;
  const double smallest = sigma[sigma.size() - 1];
  return smallest > 0.0 ? sigma[0] / smallest : std::numeric_limits<double>::infinity();
}

void sort_eigenvalues(std::vector<Eigenvalue>& list) {
  std::vector<double> moduli;
  moduli.reserve(list.size());
  for (const Eigenvalue& value : list) moduli.push_back(std::abs(value.value));
  // By insertion: a modulus is taken once, and lists of one branch are nearly in order.
  for (std::size_t i = 1; i < list.size(); ++i) {
    const Eigenvalue value = list[i];
    const double modulus = moduli[i];
    const auto comes_before = [&](std::size_t j) {
      // A conjugate pair has one modulus up to rounding of hypot; Eigen returns it bit-identical.
      return modulus != moduli[j] ? modulus > moduli[j] : value.value.imag() < list[j].value.imag();
    };
    std::size_t at = i;
    for (; at > 0 && comes_before(at - 1); --at) {
      list[at] = list[at - 1];
      moduli[at] = moduli[at - 1];
    }
    list[at] = value;
    moduli[at] = modulus;
  }
}

std::vector<Eigenvalue> eigenvalues(const Matrix& matrix, ErrorBounds errors, double uncertainty) {
  const bool wanted = errors == ErrorBounds::kGiven;
  const Index n = matrix.rows();
  if (n == 0 || !matrix.allFinite()) return {};
  // Vectors of the triangular form are as long as those of the matrix: its basis is not needed.
  const Eigen::RealSchur<Matrix> decomposition(matrix, false);
  if (decomposition.info() != Eigen::Success) return {};
  const Matrix& schur = decomposition.matrixT();
  const std::vector<Complex> values = diagonal_values(schur);
  std::vector<Eigenvalue> list;
  list.reserve(values.size());
  for (const Complex& value : values) list.push_back({value, 0.0});
  if (wanted) {
    Eigen::MatrixXcd t = schur.cast<Complex>();
    triangularise(t, values);
    ComplexVector x(n);
    const double size = static_cast<double>(n), norm = matrix.norm();
    const double roundings = size + uncertainty;
    const double unit = std::numeric_limits<double>::epsilon() * roundings * norm;
    const double elsner = std::pow(norm + unit, 1.0 - 1.0 / size) * std::pow(unit, 1.0 / size);
    bool told = true, stopped = false;  // distinct: each eigenvalue alone is known to differ from
                                        // zero
    for (Index j = 0; j < n; ++j) {
      stopped = stopped || StopScope::is_over();
      Eigenvalue& value = list[static_cast<std::size_t>(j)];
      value.error = stopped ? elsner : unit * condition_of(t, j, x);
      told = told && (stopped || value.error <= std::abs(value.value));
    }
    if (!told) bound_together({t}, roundings, 0, list);
    for (Eigenvalue& value : list) value.error = value.error < elsner ? value.error : elsner;
  }
  sort_eigenvalues(list);
  return list;
}

ComplexModes complex_modes(const Matrix& matrix) {
  ComplexModes modes;
  modes.condition = std::numeric_limits<double>::infinity();
  if (StopScope::is_over()) return modes;
  const Eigen::EigenSolver<Matrix> solver(matrix, true);
  if (solver.info() != Eigen::Success) return modes;
  modes.values = solver.eigenvalues();
  modes.vectors = solver.eigenvectors();
  modes.inverse = inverse(modes.vectors);
  const double condition = modes.vectors.norm() * modes.inverse.norm();
  // The solver returns no valid vectors for a pair that coincides to the last bit.
  const double residual =
      (matrix.cast<Complex>() * modes.vectors - modes.vectors * modes.values.asDiagonal()).norm();
  const double backward = kRoundingsOfModes * static_cast<double>(matrix.rows()) *
                          std::numeric_limits<double>::epsilon() * matrix.norm();
  modes.error = backward * condition;  // by Bauer and Fike
  if (std::isfinite(condition) && residual <= backward * modes.vectors.norm())
    modes.condition = condition;
  return modes;
}

SymmetricModes symmetric_modes(const Matrix& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double norm_growth_rate(const Matrix& matrix) {
  const Matrix symmetric = 0.5 * (matrix + matrix.transpose());
  const std::vector<Eigenvalue> list = eigenvalues(symmetric, ErrorBounds::kLeftOut);
  // No eigenvalue is larger; nor is one where none were found.
  double fastest = list.empty() ? symmetric.norm() : -symmetric.norm();
  for (const Eigenvalue& l : list) fastest = std::max(fastest, l.value.real());
  return fastest;
}

Matrix matrix_exponential(const Matrix& matrix) {
  // A structure held in all its directions has no coordinates: the exponential of an empty matrix.
  if (matrix.rows() == 0) return matrix;
  return matrix.exp();
}

Vector null_vector(const Matrix& matrix) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(matrix.transpose());
  const Matrix q = qr.householderQ();
  return q.col(q.cols() - 1);
}

NullSpaces null_spaces(const Matrix& matrix, int dimension) {
  const Eigen::Index n = matrix.cols();
  const SingularValues<double> factors = singular_values<double>(matrix.transpose());
  // What the right vectors of the other values leave free.
  const Matrix others = factors.left.leftCols(n - dimension);
  return {orthonormal_columns<double>(others, n).rightCols(dimension),
          factors.right.rightCols(dimension - 1)};
}

}  // namespace graze
