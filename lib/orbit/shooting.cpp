#include "graze/orbit/shooting.hpp"

#include <limits>

#include "graze/base/angle.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// What a stop sees of the state before an impact.
struct Impact {
  double reach = 0.0;       // row.q, m
  double jump = 0.0;        // (1 + r) v, m/s
  double slope = 0.0;       // its derivative by v
  double reach_rate = 0.0;  // along the system's tangent, at a fixed state
  double jump_rate = 0.0;
};

// `rate`: the stop's derivative along the system's tangent, or null.
Impact impact_of(const RigidStop& stop, const RigidStop* rate, const ShootingScale& scale,
                 const double* state) {
  const Eigen::Index n = stop.row.size();
  Impact impact;
  double v = 0.0, v_rate = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double q = state[j] * scale.displacement, qdot = state[n + j] * scale.velocity[j];
    impact.reach += stop.row[j] * q;
    v += stop.row[j] * qdot;
    if (rate == nullptr) continue;
    impact.reach_rate += rate->row[j] * q;
    v_rate += rate->row[j] * qdot;
  }
  impact.jump = (1.0 + stop.restitution.at(v)) * v;
  impact.slope = jump_slope(stop, v);
  if (rate != nullptr)
    impact.jump_rate = stop.restitution.rate_at(v, rate->restitution) * v + impact.slope * v_rate;
  return impact;
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

double still_gap(const System& system) { return 1e-12 * shooting_scale(system).length; }

const RigidStop& stop_of(const System& system, const ImpactPattern& pattern, std::size_t i) {
  return system.stops[static_cast<std::size_t>(pattern.stops[i])];
}

double flight_time(const System& system, const ImpactPattern& pattern,
                   const std::vector<ImpactPoint>& points, std::size_t i) {
  const bool last = i + 1 == points.size();
  const double turn = last ? kTurn * pattern.period : 0.0;
  // In this order: for k = 1 the turn comes out unrounded.
  return (points[last ? 0 : i + 1].theta - points[i].theta + turn) / system.forcing->frequency;
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

void ShootingProblem::add_mode(const System& system, const RigidStop& stop, double jump_slope,
                               const ModeTransition& arc, Eigen::Index j, Eigen::Index at,
                               Eigen::Index to, Matrix& jacobian) const {
  const Eigen::Index n = system.modes(), row = at + 1 + j, row_v = row + n;
  const double unit = scale_.displacement, unit_v = scale_.velocity[j];
  const double frequency = system.forcing->frequency;
  const double end_rate = arc.qdot / unit / frequency;
  const double end_rate_v = arc.acceleration / unit_v / frequency;
  jacobian(row, at) += arc.phase_rate_q / unit - end_rate;
  jacobian(row_v, at) += arc.phase_rate_qdot / unit_v - end_rate_v;
  jacobian(row, to) += end_rate;
  jacobian(row_v, to) += end_rate_v;
  jacobian(row, at + 1 + j) += arc.qq;
  jacobian(row, at + 1 + n + j) += arc.qv * unit_v / unit;
  jacobian(row_v, at + 1 + j) += arc.vq * unit / unit_v;
  jacobian(row_v, at + 1 + n + j) += arc.vv;
  // The jump of this mode by the velocities of all.
  const double jump = jump_slope * stop.direction[j];
  for (Eigen::Index m = 0; m < n; ++m) {
    const double by = jump * stop.row[m] * scale_.velocity[m];
    jacobian(row, at + 1 + n + m) -= arc.qv / unit * by;
    jacobian(row_v, at + 1 + n + m) -= arc.vv / unit_v * by;
  }
  jacobian(row, to + 1 + j) -= 1.0;
  jacobian(row_v, to + 1 + n + j) -= 1.0;
}

Vector ShootingProblem::residual(const System& system, const Vector& x, Matrix* jacobian,
                                 const System* tangent, Vector* parameter_derivative) const {
  const Eigen::Index n = system.modes(), block = 2 * n + 1;
  const int k = pattern_.impacts();
  const ExactFlow<double> flow(system);
  Vector r(x.size());
  if (jacobian) jacobian->setZero(x.size(), x.size());
  if (parameter_derivative) parameter_derivative->resize(x.size());
  for (int i = 0; i < k; ++i) {
    const Eigen::Index at = i * block, to = i + 1 == k ? 0 : at + block;
    const auto which = static_cast<std::size_t>(pattern_.stops[static_cast<std::size_t>(i)]);
    const RigidStop& stop = system.stops[which];
    const RigidStop* rate = parameter_derivative ? &tangent->stops[which] : nullptr;
    const Impact impact = impact_of(stop, rate, scale_, x.data() + at + 1);
    const double turn = i + 1 == k ? kTurn * pattern_.period : 0.0;
    const double theta = x[at], s = (x[to] - theta + turn) / system.forcing->frequency;
    const ModalTransitions arcs(system, flow, theta, s);
    r[at] = (impact.reach - stop.gap) / scale_.length;
    if (jacobian)
      jacobian->row(at).segment(at + 1, n) +=
          stop.row.transpose() * (scale_.displacement / scale_.length);
    if (rate) (*parameter_derivative)[at] = (impact.reach_rate - rate->gap) / scale_.length;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double unit = scale_.displacement, unit_v = scale_.velocity[j];
      const double q = x[at + 1 + j] * unit;
      const double qdot = x[at + 1 + n + j] * unit_v - impact.jump * stop.direction[j];
      const ModeTransition arc = arcs.from(j, q, qdot);
      r[at + 1 + j] = arc.q / unit - x[to + 1 + j];
      r[at + 1 + n + j] = arc.qdot / unit_v - x[to + 1 + n + j];
      if (jacobian) add_mode(system, stop, impact.slope, arc, j, at, to, *jacobian);
      if (rate) {
        const Eigen::Vector2d end = arcs.tangent(j, q, qdot, arc, *tangent);
        const double qdot_rate =
            -impact.jump_rate * stop.direction[j] - impact.jump * rate->direction[j];
        (*parameter_derivative)[at + 1 + j] = (arc.qv * qdot_rate + end[0]) / unit;
        (*parameter_derivative)[at + 1 + n + j] = (arc.vv * qdot_rate + end[1]) / unit_v;
      }
    }
  }
  return r;
}

}  // namespace graze
