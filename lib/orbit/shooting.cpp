#include "graze/orbit/shooting.hpp"

#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/flow/transition.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Derivative of the state after an impact along the system's tangent, at a fixed state before.
State after_impact_tangent(const RigidStop& stop, const RigidStop& rate, const State& before) {
  const double v = stop.row.dot(before.qdot);
  const double v_rate = rate.row.dot(before.qdot);
  const double r_rate = stop.restitution.rate_at(v, rate.restitution);
  return {Vector::Zero(before.q.size()),
          -(r_rate * v + jump_slope(stop, v) * v_rate) * stop.direction -
              (1.0 + stop.restitution.at(v)) * v * rate.direction};
}

}  // namespace

ShootingScale shooting_scale(const System& system) {
  const double frequency = system.forcing->frequency;
  ShootingScale scale{0.0, 0.0, {}};
  for (const RigidStop& stop : system.stops) {
    const double reach = reach_at(system, stop);
    if (reach > scale.length) {
      scale.length = reach;
      scale.displacement = reach / stop.row.norm();
    }
  }
  if (!(scale.length > 0.0)) scale.length = scale.displacement = 1.0;
  scale.velocity = scale.displacement * system.omega.cwiseMax(frequency);
  return scale;
}

double still_speed(const System& system) {
  // Some sixteen roundings of forced displacement and forcing frequency.
  return 16.0 * std::numeric_limits<double>::epsilon() * shooting_scale(system).length *
         system.forcing->frequency;
}

double jump_slope(const RigidStop& stop, double v) {
  return 1.0 + stop.restitution.at(v) + v * stop.restitution.slope_at(v);
}

State after_impact(const RigidStop& stop, const State& before) {
  const double v = stop.row.dot(before.qdot);
  const double jump = (1.0 + stop.restitution.at(v)) * v;
  return {before.q, before.qdot - jump * stop.direction};
}

Eigen::Index ShootingProblem::size(const System& system) const {
  return pattern_.impacts() * (2 * system.modes() + 1);
}

Vector ShootingProblem::pack(const std::vector<ImpactPoint>& impacts) const {
  const Eigen::Index n = impacts.front().before.q.size();
  Vector x(static_cast<Eigen::Index>(impacts.size()) * (2 * n + 1));
  Eigen::Index at = 0;
  for (const ImpactPoint& impact : impacts) {
    x[at] = impact.theta;
    x.segment(at + 1, n) = impact.before.q / scale_.displacement;
    x.segment(at + 1 + n, n) = impact.before.qdot.cwiseQuotient(scale_.velocity);
    at += 2 * n + 1;
  }
  return x;
}

std::vector<ImpactPoint> ShootingProblem::unpack(const System& system, const Vector& x) const {
  const Eigen::Index n = system.modes();
  std::vector<ImpactPoint> impacts;
  for (Eigen::Index at = 0; at < x.size(); at += 2 * n + 1)
    impacts.push_back({x[at],
                       {x.segment(at + 1, n) * scale_.displacement,
                        x.segment(at + 1 + n, n).cwiseProduct(scale_.velocity)}});
  return impacts;
}

Vector ShootingProblem::residual(const System& system, const Vector& x, Matrix* jacobian,
                                 const System* tangent, Vector* parameter_derivative) const {
  const Eigen::Index n = system.modes(), block = 2 * n + 1;
  const int k = pattern_.impacts();
  const double frequency = system.forcing->frequency;
  const ExactFlow<double> flow(system);
  const std::vector<ImpactPoint> impacts = unpack(system, x);
  Vector unit(2 * n);  // of a scaled state
  unit << Vector::Constant(n, scale_.displacement), scale_.velocity;
  const auto scaled = [&](const State& state) {
    Vector y(2 * n);
    y << state.q, state.qdot;
    return Vector(y.cwiseQuotient(unit));
  };

  Vector r(x.size());
  if (jacobian) jacobian->setZero(x.size(), x.size());
  if (parameter_derivative) parameter_derivative->setZero(x.size());
  for (int i = 0; i < k; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const auto next = static_cast<std::size_t>((i + 1) % k);
    const auto which = static_cast<std::size_t>(pattern_.stops[index]);
    const RigidStop& stop = system.stops[which];
    const ImpactPoint& impact = impacts[index];
    const double turn = i + 1 == k ? kTurn * pattern_.period : 0.0;
    const double s = (impacts[next].theta - impact.theta + turn) / frequency;
    const State after = after_impact(stop, impact.before);
    const Transition arc = transition(system, flow, after, impact.theta, s);

    const Eigen::Index at = i * block, to = static_cast<Eigen::Index>(next) * block;
    r[at] = (stop.row.dot(impact.before.q) - stop.gap) / scale_.length;
    r.segment(at + 1, 2 * n) = scaled(arc.end) - x.segment(to + 1, 2 * n);

    if (jacobian) {
      const Vector end_by_phase = scaled(arc.end_rate) / frequency;
      jacobian->block(at, at + 1, 1, n) +=
          stop.row.transpose() * (scale_.displacement / scale_.length);
      jacobian->block(at + 1, at, 2 * n, 1) += scaled(arc.phase_rate) - end_by_phase;
      jacobian->block(at + 1, to, 2 * n, 1) += end_by_phase;
      Matrix jump = unit.asDiagonal();
      jump.bottomRightCorner(n, n) -= jump_slope(stop, stop.row.dot(impact.before.qdot)) *
                                      stop.direction *
                                      stop.row.cwiseProduct(scale_.velocity).transpose();
      jacobian->block(at + 1, at + 1, 2 * n, 2 * n) +=
          unit.cwiseInverse().asDiagonal() * arc.flow.times(jump);
      jacobian->block(at + 1, to + 1, 2 * n, 2 * n) -= Matrix::Identity(2 * n, 2 * n);
    }
    if (parameter_derivative) {
      const RigidStop& rate = tangent->stops[which];
      const State jump_rate = after_impact_tangent(stop, rate, impact.before);
      Matrix start_rate(2 * n, 1);
      start_rate << jump_rate.q, jump_rate.qdot;
      const Vector carried = arc.flow.times(start_rate);
      (*parameter_derivative)[at] = (rate.row.dot(impact.before.q) - rate.gap) / scale_.length;
      parameter_derivative->segment(at + 1, 2 * n) =
          carried.cwiseQuotient(unit) +
          scaled(end_tangent(system, *tangent, flow, after, impact.theta, s));
    }
  }
  return r;
}

}  // namespace graze
