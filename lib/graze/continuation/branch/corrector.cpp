#include "graze/continuation/branch/detail/corrector.hpp"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

constexpr int kMostCorrections = 8;
// A step this small leaves an error of its square, below rounding.
constexpr double kCorrectorSettled = 1e-8;

// Roundings of an entry of F: more than its terms have, less than a distance to another solution.
constexpr double kRoundingsOfEquation = 1024.0;

// Whether each entry of F is within the effect of the rounding of x.
bool is_rounding_of(const Vector& residual, const Matrix& rates, const Vector& x) {
  const Vector size = rates.cwiseAbs() * x.cwiseAbs();
  return (residual.cwiseAbs().array() <=
          kRoundingsOfEquation * std::numeric_limits<double>::epsilon() * size.array())
      .all();
}

// Factorised in place: the matrix is no longer needed.
using InPlaceLU = Eigen::PartialPivLU<Eigen::Ref<Matrix>>;

// The right-hand side (-residual, 0).
Vector correction_target(const Vector& residual) {
  Vector target(residual.size() + 1);
  target << -residual, 0.0;
  return target;
}

}  // namespace

Corrector::Corrector(const ZeroProblem& problem, const ContinuationOptions& options)
    : problem_(problem), options_(options), range_(std::abs(options.to - options.from)) {
  if (!(range_ > 0.0)) range_ = 1.0;
}

Vector Corrector::pack(const SolutionPoint& point) const {
  Vector x(point.u.size() + 1);
  x << point.u, point.parameter / range_;
  return x;
}

SolutionPoint Corrector::unpack(const Vector& x, const Vector& tangent, double residual,
                                int sign) const {
  const Eigen::Index n = x.size() - 1;
  return {x.head(n), x[n] * range_, tangent, residual, sign, {}};
}

std::optional<Corrector::Linearised> Corrector::linearise(const Vector& x, const Vector& normal) {
  if (StopScope::is_over()) return {};
  const Eigen::Index n = x.size() - 1;
  ++evaluations_;
  const double parameter = x[n] * range_;
  std::optional<ZeroEvaluation> at = problem_.evaluate(x.head(n), Parameters(&parameter, 1));
  if (!at || !at->residual.allFinite() || !at->jacobian.allFinite() ||
      !at->by_parameters.allFinite())
    return {};
  Linearised result{std::move(at->residual), Matrix(n + 1, n + 1)};
  result.bordered.topLeftCorner(n, n) = at->jacobian;
  result.bordered.col(n).head(n) = at->by_parameters * range_;
  result.bordered.row(n) = normal.transpose();
  return result;
}

std::optional<SolutionPoint> Corrector::solve(Vector x, const Vector& normal, double contraction) {
  const Eigen::Index n = x.size() - 1;
  double last = std::numeric_limits<double>::infinity(), before = last;
  for (int i = 0; i < kMostCorrections; ++i) {
    std::optional<Linearised> at = linearise(x, normal);
    if (!at) return {};
    const double residual = at->residual.cwiseAbs().maxCoeff();
    // A residual that is not halved by so small a correction is rounding, if it is within that.
    const bool is_rounding = 2.0 * residual >= before &&
                             last <= options_.residual_tolerance * (1.0 + x.norm()) &&
                             is_rounding_of(at->residual, at->bordered.topRows(n), x);
    const InPlaceLU lu(at->bordered);
    if ((residual <= options_.residual_tolerance && last <= kCorrectorSettled) || is_rounding) {
      const Vector tangent = lu.solve(Vector::Unit(n + 1, n)).normalized();
      if (!tangent.allFinite()) return {};
      // The tangent leans to the side of the normal, so its determinant has the normal's sign.
      return unpack(x, tangent, residual, lu.determinant() < 0.0 ? -1 : 1);
    }
    const Vector step = lu.solve(correction_target(at->residual));
    const double size = step.norm();
    if (!std::isfinite(size) || (size > contraction * last && size > kCorrectorSettled)) return {};
    x += step;
    last = size;
    before = residual;
  }
  return {};
}

std::optional<SolutionPoint> Corrector::on_hyperplane(const Vector& guess, const Vector& normal,
                                                      double contraction) {
  return solve(guess, normal, contraction);
}

std::optional<Vector> Corrector::newton_step(const Vector& guess, const Vector& normal) {
  std::optional<Linearised> at = linearise(guess, normal);
  if (!at) return {};
  const Vector step = InPlaceLU(at->bordered).solve(correction_target(at->residual));
  if (!step.allFinite()) return {};
  return guess + step;
}

double Corrector::determinant_ratio(const SolutionPoint& a, const SolutionPoint& b) {
  std::optional<Linearised> at_a = linearise(pack(a), a.tangent),
                            at_b = linearise(pack(b), b.tangent);
  if (!at_a || !at_b) return std::numeric_limits<double>::quiet_NaN();
  // Compares the triangular factors entry by entry: the determinants themselves might overflow.
  const Vector pivots_a = InPlaceLU(at_a->bordered).matrixLU().diagonal();
  const Vector pivots_b = InPlaceLU(at_b->bordered).matrixLU().diagonal();
  double logarithm = 0.0;
  for (Eigen::Index i = 0; i < pivots_a.size(); ++i)
    logarithm += std::log(std::abs(pivots_b[i])) - std::log(std::abs(pivots_a[i]));
  return std::exp(logarithm);
}

std::optional<Matrix> Corrector::slope_at(const Vector& x) {
  const Eigen::Index n = x.size() - 1;
  const std::optional<Linearised> at = linearise(x, Vector::Zero(n + 1));
  if (!at) return {};
  return at->bordered.topRows(n);
}

std::optional<double> Corrector::residual_at(const Vector& x) {
  const std::optional<Linearised> at = linearise(x, Vector::Zero(x.size()));
  if (!at) return {};
  return at->residual.cwiseAbs().maxCoeff();
}

std::optional<SolutionPoint> Corrector::at_parameter(const Vector& guess) {
  // Newton at a fixed parameter is Newton on the hyperplane normal to the parameter's axis; only
  // the tangent has to be computed without it, for it may lie in that hyperplane.
  const Eigen::Index n = guess.size() - 1;
  std::optional<SolutionPoint> point = solve(guess, Vector::Unit(n + 1, n), kConvergent);
  if (!point) return {};
  std::optional<Linearised> at = linearise(pack(*point), Vector::Zero(n + 1));
  if (!at) return {};
  point->tangent = null_vector(at->bordered.topRows(n));
  if (point->tangent[n] < 0.0) point->tangent *= -1.0;
  at->bordered.row(n) = point->tangent.transpose();
  point->orientation = InPlaceLU(at->bordered).determinant() < 0.0 ? -1 : 1;
  return point;
}

Vector Corrector::difference(const Vector& x, const Vector& y) const {
  Vector d = x - y;
  const double turn = problem_.wrap.squaredNorm();  // 0 where no unknown is periodic
  if (turn == 0.0) return d;
  const Eigen::Index n = problem_.wrap.size();
  const double rounds = d.head(n).dot(problem_.wrap) / turn;
  d.head(n) -= std::round(rounds) * problem_.wrap;
  return d;
}

}  // namespace graze
