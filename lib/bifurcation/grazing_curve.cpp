#include "graze/bifurcation/grazing_curve.hpp"

#include <utility>

namespace graze {

GrazingCurve::GrazingCurve(const Scene& scene, const std::string& first, const std::string& second,
                           ImpactPattern pattern, std::size_t touch, const MotionScale& scale,
                           double range)
    : systems_(scene, {first, second}),
      shooting_(std::move(pattern), scale),
      touch_(touch),
      range_(range),
      speed_unit_(scale.speed) {
  ZeroProblem& zero = problem_.problem;
  zero.evaluate = [this](const Vector& y, Parameters at) { return evaluate(y, at[0]); };
  if (shooting_.pattern().impacts() > 1)
    zero.multipliers = [this](const Vector& y, Parameters at, ErrorBounds errors) {
      return multipliers(y, at[0], errors);
    };
  const Vector wrap = shooting_.wrap();
  problem_.first = wrap.size();
  zero.wrap.resize(problem_.first + 1);
  zero.wrap << wrap, 0.0;
}

Vector GrazingCurve::pack(const std::vector<ImpactPoint>& impacts, double first) const {
  Vector y(problem_.first + 1);
  y << shooting_.pack(impacts), first / range_;
  return y;
}

double GrazingCurve::first_of(const BranchPoint& point) const {
  return point.u[problem_.first] * range_;
}

std::vector<ImpactPoint> GrazingCurve::impacts_of(const BranchPoint& point) const {
  return shooting_.unpack(*system_at(first_of(point), point.parameter),
                          point.u.head(problem_.first));
}

const System* GrazingCurve::system_at(double first, double second) const {
  return systems_.at(std::array{first, second});
}

std::optional<ZeroEvaluation> GrazingCurve::evaluate(const Vector& y, double second) const {
  const Eigen::Index n = problem_.first;
  const std::array values{y[n] * range_, second};
  const System* system = systems_.at(values);
  if (!system) return {};
  const std::array<const System*, 2> tangents{systems_.tangent_at(values, 0),
                                              systems_.tangent_at(values, 1)};
  const ShootingLinearisation of = shooting_.linearise(*system, y.head(n), tangents);
  ZeroEvaluation at{Vector(n + 1), Matrix::Zero(n + 1, n + 1), Vector(n + 1)};
  at.residual.head(n) = of.residual;
  at.jacobian.topLeftCorner(n, n) = of.jacobian;
  at.jacobian.col(n).head(n) = of.by_parameters.col(0) * range_;
  at.by_parameters.col(0).head(n) = of.by_parameters.col(1);
  // The speed of the impact that touches.
  const Eigen::Index modes = system->modes();
  const Eigen::Index first = static_cast<Eigen::Index>(touch_) * (2 * modes + 1) + 1 + modes;
  const auto stop = static_cast<std::size_t>(shooting_.pattern().stops[touch_]);
  const Vector units = shooting_.scale().velocity / speed_unit_;
  const Vector qdot = y.segment(first, modes).cwiseProduct(units);
  const Vector& row = system->stops[stop].row;
  at.residual[n] = row.dot(qdot);
  at.jacobian.row(n).segment(first, modes) = row.cwiseProduct(units).transpose();
  at.jacobian(n, n) = tangents[0]->stops[stop].row.dot(qdot) * range_;
  at.by_parameters(n, 0) = tangents[1]->stops[stop].row.dot(qdot);
  return at;
}

std::vector<Eigenvalue> GrazingCurve::multipliers(const Vector& y, double second,
                                                  ErrorBounds errors) const {
  const Eigen::Index n = problem_.first;
  const System* system = system_at(y[n] * range_, second);
  if (!system) return {};
  const TouchingOrbit orbit =
      without_touch({shooting_.pattern(), shooting_.unpack(*system, y.head(n)), touch_});
  return orbit_multipliers(*system, orbit.pattern, orbit.impacts, errors);
}

}  // namespace graze
