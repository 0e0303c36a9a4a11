#include "graze/continuation/special/detail/branch_crossing.hpp"

#include <cmath>
#include <limits>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {
namespace {

constexpr int kMostIterations = 8;
// A step this small leaves an error of its square, and of its product with the error of the
// differences (1e-10): below rounding.
constexpr double kSettled = 1e-8;

struct Singularity {
  Vector value;  // g, 2
  Matrix slope;  // dg/dx, 2 x (n + 1)
};

// g at x and its derivative. With [w^T, h^T] [dF/dx, b; C, 0] = (0, 1) the latter is
// -w^T F_xx V. Its second derivatives are differences: they only lead to the solution, and what
// decides on it is free of them. Their step balances the rounding of dF/dx against its third
// derivative.
std::optional<Singularity> singularity(Corrector& corrector, const Vector& x, const Matrix& slope,
                                       const NullSpaces& borders) {
  const Eigen::Index n = slope.rows();
  Matrix bordered = Matrix::Zero(n + 2, n + 2);
  bordered.topLeftCorner(n, n + 1) = slope;
  bordered.col(n + 1).head(n) = borders.left.col(0);
  bordered.bottomLeftCorner(2, n + 1) = borders.right.transpose();
  const LuFactors lu(bordered);
  Matrix identity = Matrix::Zero(n + 2, 2);
  identity.bottomRows(2).setIdentity();
  const Matrix solution = lu.solve_columns(identity);
  Vector left = lu.solve_transposed(Vector::Unit(n + 2, n + 1));
  left.conservativeResize(n);
  const double step = std::cbrt(std::numeric_limits<double>::epsilon()) * (1.0 + x.norm());
  Singularity result{solution.row(n + 1).transpose(), Matrix(2, n + 1)};
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Vector direction = solution.col(k).head(n + 1);
    const std::optional<Matrix> ahead = corrector.slope_at(x + step * direction),
                                behind = corrector.slope_at(x - step * direction);
    if (!ahead || !behind) return {};
    result.slope.row(k) = -left.transpose() * (*ahead - *behind) / (2.0 * step);
  }
  return result;
}

}  // namespace

std::optional<Vector> crossing_near(Corrector& corrector, const Vector& guess) {
  const Eigen::Index n = guess.size() - 1;
  Vector x = guess;
  double unfolding = 0.0, last = std::numeric_limits<double>::infinity();
  std::optional<NullSpaces> borders;
  for (int i = 0; i < kMostIterations; ++i) {
    const auto at = corrector.linearise(x, Vector::Zero(n + 1));
    if (!at) return {};
    const Matrix slope = at->bordered.topRows(n);
    if (!borders) borders = null_spaces(slope, 2);
    const std::optional<Singularity> singular = singularity(corrector, x, slope, *borders);
    if (!singular) return {};
    Matrix jacobian = Matrix::Zero(n + 2, n + 2);
    jacobian.topLeftCorner(n, n + 1) = slope;
    jacobian.col(n + 1).head(n) = borders->left.col(0);
    jacobian.bottomLeftCorner(2, n + 1) = singular->slope;
    Vector target(n + 2);
    target << -at->residual - unfolding * borders->left.col(0), -singular->value;
    const Vector step = LuFactors(jacobian).solve(target);
    const double size = step.norm();
    if (!std::isfinite(size) || (size > 0.5 * last && size > kSettled)) return {};
    x += step.head(n + 1);
    unfolding += step[n + 1];
    if (size <= kSettled) return x;
    last = size;
  }
  return {};
}

}  // namespace graze
