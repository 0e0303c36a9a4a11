#include "graze/orbit/problem/detail/shooting.hpp"

#include <limits>

#include "graze/base/angle.hpp"
#include "graze/orbit/problem/detail/impact_coordinates.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Speed and jump of an impact at a stop, from the state before it.
struct Impact {
  double reach = 0.0;  // row.q, m
  double speed = 0.0;  // row.q', m/s
  double jump = 0.0;   // (1 + r) v, m/s
  double slope = 0.0;  // its derivative by v
};
// Their derivatives along a tangent of the system, at a fixed state.
struct ImpactRate {
  double reach = 0.0, jump = 0.0;
};

Impact impact_of(const Stop& stop, const MotionScale& scale, const double* state) {
  const Eigen::Index n = stop.row.size();
  Impact impact;
  for (Eigen::Index j = 0; j < n; ++j) {
    impact.reach += stop.row[j] * (state[j] * scale.displacement);
    impact.speed += stop.row[j] * (state[n + j] * scale.velocity[j]);
  }
  impact.jump = stop.restitution().jump(impact.speed);
  impact.slope = stop.restitution().jump_slope(impact.speed);
  return impact;
}

ImpactRate rate_of(const Impact& impact, const Stop& stop, const Stop& tangent,
                   const MotionScale& scale, const double* state) {
  const Eigen::Index n = stop.row.size();
  ImpactRate rate;
  double v_rate = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    rate.reach += tangent.row[j] * (state[j] * scale.displacement);
    v_rate += tangent.row[j] * (state[n + j] * scale.velocity[j]);
  }
  rate.jump =
      stop.restitution().jump_rate(impact.speed, tangent.restitution()) + impact.slope * v_rate;
  return rate;
}

}  // namespace

State after_impact(const Stop& stop, const State& before) {
  const double jump = stop.restitution().jump(stop.row.dot(before.qdot));
  return {before.q, before.qdot - jump * stop.direction()};
}

Eigen::Index ShootingProblem::size(const System& system) const {
  return pattern_.impacts() * (2 * system.modes() + 1);
}

Vector ShootingProblem::wrap() const {
  const Eigen::Index block = 2 * scale_.velocity.size() + 1;
  Vector turns = Vector::Zero(block * pattern_.impacts());
  for (Eigen::Index at = 0; at < turns.size(); at += block) turns[at] = kTurn;
  return turns;
}

Vector ShootingProblem::pack(const System& system, const std::vector<ImpactPoint>& impacts) const {
  const Eigen::Index n = impacts.front().before.q.size();
  Vector x(static_cast<Eigen::Index>(impacts.size()) * (2 * n + 1));
  Eigen::Index at = 0;
  for (const ImpactPoint& impact : impacts) {
    x[at] = impact.theta;
    x.segment(at + 1, n) = impact.before.q / scale_.displacement;
    x.segment(at + 1 + n, n) = impact.before.qdot.cwiseQuotient(scale_.velocity);
    at += 2 * n + 1;
  }
  return system.coordinates() ? ImpactCoordinates(*system.coordinates(), scale_).turned(x) : x;
}

std::vector<ImpactPoint> ShootingProblem::unpack(const System& system, const Vector& x) const {
  const Eigen::Index n = system.modes();
  const Vector y =
      system.coordinates() ? ImpactCoordinates(*system.coordinates(), scale_).back(x) : x;
  std::vector<ImpactPoint> impacts;
  for (Eigen::Index at = 0; at < y.size(); at += 2 * n + 1)
    impacts.push_back({y[at],
                       {y.segment(at + 1, n) * scale_.displacement,
                        y.segment(at + 1 + n, n).cwiseProduct(scale_.velocity)}});
  return impacts;
}

void ShootingProblem::add_mode(const System& system, const Stop& stop, double jump_slope,
                               const ModeTransition& arc, Eigen::Index j, Eigen::Index at,
                               Matrix& jacobian) const {
  const Eigen::Index n = system.modes(), row = at + 1 + j, row_v = row + n;
  const double unit = scale_.displacement, unit_v = scale_.velocity[j];
  const double frequency = system.forcing()->frequency;
  jacobian(row, at) += arc.phase_rate_q / unit - arc.qdot / unit / frequency;
  jacobian(row_v, at) += arc.phase_rate_qdot / unit_v - arc.acceleration / unit_v / frequency;
  jacobian(row, at + 1 + j) += arc.qq;
  jacobian(row, at + 1 + n + j) += arc.qv * unit_v / unit;
  jacobian(row_v, at + 1 + j) += arc.vq * unit / unit_v;
  jacobian(row_v, at + 1 + n + j) += arc.vv;
  // Jump of this mode caused by the velocities of all modes.
  const double jump = jump_slope * stop.direction()[j];
  for (Eigen::Index m = 0; m < n; ++m) {
    const double by = jump * stop.row[m] * scale_.velocity[m];
    jacobian(row, at + 1 + n + m) -= arc.qv / unit * by;
    jacobian(row_v, at + 1 + n + m) -= arc.vv / unit_v * by;
  }
}

void ShootingProblem::add_end(const System& system, const ModeTransition& arc, Eigen::Index j,
                              Eigen::Index at, Eigen::Index to, Matrix& jacobian) const {
  const Eigen::Index n = system.modes(), row = at + 1 + j, row_v = row + n;
  const double frequency = system.forcing()->frequency;
  jacobian(row, to) += arc.qdot / scale_.displacement / frequency;
  jacobian(row_v, to) += arc.acceleration / scale_.velocity[j] / frequency;
  jacobian(row, to + 1 + j) -= 1.0;
  jacobian(row_v, to + 1 + n + j) -= 1.0;
}

Vector ShootingProblem::residual(const System& system, const Vector& x, Matrix* jacobian) const {
  if (!system.coordinates()) return evaluate(system, x, {.jacobian = jacobian});
  ShootingLinearisation at = linearise(system, x, {});
  if (jacobian) *jacobian = std::move(at.jacobian);
  return std::move(at.residual);
}

ShootingLinearisation ShootingProblem::linearise(const System& system, const Vector& x,
                                                 std::span<const System* const> tangents) const {
  if (!system.coordinates()) return modal_equations(system, x, tangents);
  const ImpactCoordinates coordinates(*system.coordinates(), scale_);
  const Vector y = coordinates.back(x);
  ShootingLinearisation at = modal_equations(system, y, tangents);
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    const auto column = static_cast<Eigen::Index>(p);
    const Vector moved = coordinates.back(coordinates.rate(*tangents[p], y));
    const Vector rates = at.by_parameters.col(column) - at.jacobian * moved;
    at.by_parameters.col(column) =
        coordinates.turned(rates) + coordinates.rate(*tangents[p], at.residual);
  }
  at.jacobian = coordinates.similar(at.jacobian);
  at.closing = coordinates.similar(at.closing);
  at.residual = coordinates.turned(at.residual);
  return at;
}

ShootingLinearisation ShootingProblem::modal_equations(
    const System& system, const Vector& y, std::span<const System* const> tangents) const {
  ShootingLinearisation at;
  at.by_parameters.resize(y.size(), static_cast<Eigen::Index>(tangents.size()));
  at.residual = evaluate(system, y, {&at.jacobian, &at.closing, tangents, &at.by_parameters});
  return at;
}

ShootingProblem::ImpactSpeed ShootingProblem::speed_of(
    const System& system, const Vector& x, std::size_t impact,
    std::span<const System* const> tangents) const {
  const auto which = static_cast<std::size_t>(pattern_.stops[impact]);
  const Vector qdot = unpack(system, x)[impact].before.qdot, units = scale_.velocity / scale_.speed;
  const Eigen::Index n = system.modes(), first = static_cast<Eigen::Index>(impact) * (2 * n + 1);
  ImpactSpeed speed{system.stops[which].row.dot(qdot) / scale_.speed, Vector::Zero(x.size()),
                    Vector(static_cast<Eigen::Index>(tangents.size()))};
  speed.by_x.segment(first + 1 + n, n) = system.stops[which].row.cwiseProduct(units);
  for (std::size_t p = 0; p < tangents.size(); ++p)
    speed.by_parameters[static_cast<Eigen::Index>(p)] =
        tangents[p]->stops[which].row.dot(qdot) / scale_.speed;
  if (!system.coordinates()) return speed;
  const ImpactCoordinates coordinates(*system.coordinates(), scale_);
  const Vector y = coordinates.back(x);
  speed.by_x = coordinates.back_covector(speed.by_x);
  for (std::size_t p = 0; p < tangents.size(); ++p)
    speed.by_parameters[static_cast<Eigen::Index>(p)] -=
        speed.by_x.dot(coordinates.rate(*tangents[p], y));
  return speed;
}

Vector ShootingProblem::evaluate(const System& system, const Vector& x,
                                 const Wanted& wanted) const {
  const Eigen::Index n = system.modes(), block = 2 * n + 1;
  const int k = pattern_.impacts();
  const ExactFlow<double> flow(system);
  Vector r(x.size());
  if (wanted.jacobian) wanted.jacobian->setZero(x.size(), x.size());
  if (wanted.closing) wanted.closing->setZero(x.size(), x.size());
  std::vector<ImpactRate> rates(wanted.tangents.size());
  for (int i = 0; i < k; ++i) {
    const bool last = i + 1 == k;
    const Eigen::Index at = i * block, to = last ? 0 : at + block;
    const auto which = static_cast<std::size_t>(pattern_.stops[static_cast<std::size_t>(i)]);
    const Stop& stop = system.stops[which];
    const double* state = x.data() + at + 1;
    const Impact impact = impact_of(stop, scale_, state);
    const double turn = last ? kTurn * pattern_.period : 0.0;
    const double theta = x[at], s = (x[to] - theta + turn) / system.forcing()->frequency;
    const ModalTransitions arcs(system, flow, theta, s);
    r[at] = (impact.reach - stop.gap) / scale_.length;
    if (wanted.jacobian)
      wanted.jacobian->row(at).segment(at + 1, n) +=
          stop.row.transpose() * (scale_.displacement / scale_.length);
    for (std::size_t p = 0; p < rates.size(); ++p) {
      const Stop& tangent = wanted.tangents[p]->stops[which];
      rates[p] = rate_of(impact, stop, tangent, scale_, state);
      (*wanted.by_parameters)(at, static_cast<Eigen::Index>(p)) =
          (rates[p].reach - tangent.gap) / scale_.length;
    }
    for (Eigen::Index j = 0; j < n; ++j) {
      const double unit = scale_.displacement, unit_v = scale_.velocity[j];
      const double q = state[j] * unit;
      const double qdot = state[n + j] * unit_v - impact.jump * stop.direction()[j];
      const ModeTransition arc = arcs.from(j, q, qdot);
      r[at + 1 + j] = arc.q / unit - x[to + 1 + j];
      r[at + 1 + n + j] = arc.qdot / unit_v - x[to + 1 + n + j];
      if (wanted.jacobian) {
        add_mode(system, stop, impact.slope, arc, j, at, *wanted.jacobian);
        add_end(system, arc, j, at, to, *wanted.jacobian);
        if (last && wanted.closing) add_end(system, arc, j, at, to, *wanted.closing);
      }
      for (std::size_t p = 0; p < rates.size(); ++p) {
        const System& tangent = *wanted.tangents[p];
        const Eigen::Vector2d end = arcs.tangent(j, q, qdot, arc, tangent);
        const double qdot_rate = -rates[p].jump * stop.direction()[j] -
                                 impact.jump * tangent.stops[which].direction()[j];
        const auto column = static_cast<Eigen::Index>(p);
        (*wanted.by_parameters)(at + 1 + j, column) = (arc.qv * qdot_rate + end[0]) / unit;
        (*wanted.by_parameters)(at + 1 + n + j, column) = (arc.vv * qdot_rate + end[1]) / unit_v;
      }
    }
  }
  return r;
}

}  // namespace graze
