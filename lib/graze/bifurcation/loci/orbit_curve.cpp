#include "graze/bifurcation/loci/detail/orbit_curve.hpp"

#include <utility>

namespace graze {

OrbitCurve::OrbitCurve(const OrbitProblem& equations, Eigen::Index n, Eigen::Index further,
                       double unit, std::unique_ptr<LocusOrbits> orbits)
    : equations_(equations), unit_(unit), orbits_(std::move(orbits)) {
  problem_.first = n;
  problem_.problem.wrap = Vector::Zero(n + 1 + further);
  const Vector& wrap = equations.problem().wrap;
  problem_.problem.wrap.head(wrap.size()) = wrap;
  problem_.resolves = [this](const SolutionPoint& from, const SolutionPoint& to) {
    return orbits_->resolves(site_of(from), site_of(to));
  };
  problem_.proceed = [this](const SolutionPoint& previous, const SolutionPoint& here) {
    return orbits_->goes_on(site_of(previous), site_of(here));
  };
}

LocusSite OrbitCurve::site_of(const SolutionPoint& point) const {
  const Eigen::Index n = problem_.first;
  return {point.u.head(n), point.u[n] * unit_, point.parameter, 0.0,
          point.u.tail(point.u.size() - n - 1)};
}

std::optional<ZeroEvaluation> OrbitCurve::with(const Vector& y, double second,
                                               const std::optional<Condition>& condition) const {
  const Eigen::Index n = problem_.first;
  const std::optional<ZeroEvaluation> orbit =
      condition ? equations_.problem().evaluate(y.head(n), parameters_of(y, second))
                : std::optional<ZeroEvaluation>();
  if (!orbit) return {};
  ZeroEvaluation sum{Vector(n + 1), Matrix(n + 1, n + 1), Matrix(n + 1, 1),
                     Matrix::Zero(n + 1, n + 1)};
  sum.residual << orbit->residual, condition->value;
  sum.jacobian.topLeftCorner(n, n) = orbit->jacobian;
  sum.jacobian.col(n).head(n) = orbit->by_parameters.col(0) * unit_;
  sum.jacobian.row(n) = condition->slope.transpose();
  sum.by_parameters << orbit->by_parameters.col(1), condition->by_second;
  return sum;
}

}  // namespace graze
