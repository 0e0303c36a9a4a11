#include "graze/continuation/corrector.hpp"

#include <Eigen/LU>
#include <cmath>

#include "graze/base/decompositions.hpp"

namespace graze {
namespace {

constexpr int kMostIterations = 8;
// A step this small leaves an error of its square, below rounding.
constexpr double kSettled = 1e-8;

Matrix bordered(const Matrix& slope, const Vector& normal) {
  Matrix matrix(slope.rows() + 1, slope.cols());
  matrix << slope, normal.transpose();
  return matrix;
}

}  // namespace

Corrector::Corrector(const ZeroProblem& problem, const ContinuationOptions& options)
    : problem_(problem), options_(options), range_(std::abs(options.to - options.from)) {
  if (!(range_ > 0.0)) range_ = 1.0;
}

Vector Corrector::pack(const BranchPoint& point) const {
  Vector x(point.u.size() + 1);
  x << point.u, point.parameter / range_;
  return x;
}

BranchPoint Corrector::unpack(const Vector& x, const Vector& tangent, double residual,
                              int sign) const {
  const Eigen::Index n = x.size() - 1;
  return {x.head(n), x[n] * range_, tangent, residual, sign, {}};
}

std::optional<Corrector::Linearised> Corrector::linearise(const Vector& x) {
  const Eigen::Index n = x.size() - 1;
  ++evaluations_;
  const std::optional<ZeroEvaluation> at = problem_.evaluate(x.head(n), x[n] * range_);
  if (!at || !at->residual.allFinite() || !at->jacobian.allFinite() ||
      !at->parameter_derivative.allFinite())
    return {};
  Matrix slope(n, n + 1);
  slope << at->jacobian, at->parameter_derivative * range_;
  return Linearised{at->residual, slope};
}

std::optional<BranchPoint> Corrector::solve(Vector x, const Vector& normal, double contraction) {
  const Eigen::Index n = x.size() - 1;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostIterations; ++i) {
    const std::optional<Linearised> at = linearise(x);
    if (!at) return {};
    const Eigen::PartialPivLU<Matrix> lu(bordered(at->slope, normal));
    const double residual = at->residual.cwiseAbs().maxCoeff();
    if (residual <= options_.residual_tolerance && last <= kSettled) {
      const Vector tangent = lu.solve(Vector::Unit(n + 1, n)).normalized();
      if (!tangent.allFinite()) return {};
      // The tangent leans to the side of the normal, so its determinant has the normal's sign.
      return unpack(x, tangent, residual, lu.determinant() < 0.0 ? -1 : 1);
    }
    Vector target = Vector::Zero(n + 1);
    target.head(n) = -at->residual;
    const Vector step = lu.solve(target);
    const double size = step.norm();
    if (!std::isfinite(size) || (size > contraction * last && size > kSettled)) return {};
    x += step;
    last = size;
  }
  return {};
}

std::optional<BranchPoint> Corrector::on_hyperplane(const Vector& guess, const Vector& normal,
                                                    double contraction) {
  return solve(guess, normal, contraction);
}

std::optional<Vector> Corrector::newton_step(const Vector& guess, const Vector& normal) {
  const Eigen::Index n = guess.size() - 1;
  const std::optional<Linearised> at = linearise(guess);
  if (!at) return {};
  Vector target = Vector::Zero(n + 1);
  target.head(n) = -at->residual;
  const Vector step = bordered(at->slope, normal).partialPivLu().solve(target);
  if (!step.allFinite()) return {};
  return guess + step;
}

double Corrector::determinant_ratio(const BranchPoint& a, const BranchPoint& b) {
  const std::optional<Linearised> at_a = linearise(pack(a)), at_b = linearise(pack(b));
  if (!at_a || !at_b) return std::numeric_limits<double>::quiet_NaN();
  // Entry by entry of the triangular factors: the determinants themselves might overflow.
  const Vector pivots_a =
      Eigen::PartialPivLU<Matrix>(bordered(at_a->slope, a.tangent)).matrixLU().diagonal();
  const Vector pivots_b =
      Eigen::PartialPivLU<Matrix>(bordered(at_b->slope, b.tangent)).matrixLU().diagonal();
  double logarithm = 0.0;
  for (Eigen::Index i = 0; i < pivots_a.size(); ++i)
    logarithm += std::log(std::abs(pivots_b[i])) - std::log(std::abs(pivots_a[i]));
  return std::exp(logarithm);
}

std::optional<Matrix> Corrector::slope_at(const Vector& x) {
  const std::optional<Linearised> at = linearise(x);
  if (!at) return {};
  return at->slope;
}

std::optional<BranchPoint> Corrector::at_parameter(const Vector& guess) {
  // Newton at a fixed parameter is Newton on the hyperplane normal to the parameter's axis; only
  // the tangent has to be sought without it, for it may lie in that hyperplane.
  const Eigen::Index n = guess.size() - 1;
  std::optional<BranchPoint> point = solve(guess, Vector::Unit(n + 1, n), kConvergent);
  if (!point) return {};
  const std::optional<Linearised> at = linearise(pack(*point));
  if (!at) return {};
  point->tangent = null_vector(at->slope);
  if (point->tangent[n] < 0.0) point->tangent *= -1.0;
  point->orientation =
      bordered(at->slope, point->tangent).partialPivLu().determinant() < 0.0 ? -1 : 1;
  return point;
}

Vector Corrector::difference(const Vector& x, const Vector& y) const {
  Vector d = x - y;
  if (problem_.wrap.size() == 0) return d;
  const Eigen::Index n = problem_.wrap.size();
  const double rounds = d.head(n).dot(problem_.wrap) / problem_.wrap.squaredNorm();
  d.head(n) -= std::round(rounds) * problem_.wrap;
  return d;
}

}  // namespace graze
