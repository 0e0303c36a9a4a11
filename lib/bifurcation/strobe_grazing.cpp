#include "graze/bifurcation/strobe_grazing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// How deep a solution may lie beyond the touch, in lengths of the forced motion: ten times what the
// equations are solved to.
constexpr double kDepth = 1e-10;

}  // namespace

StrobeGrazing::StrobeGrazing(StrobePlane& plane, int period, int stop)
    : plane_(plane), period_(period), stop_(stop) {
  const Eigen::Index n = period * plane.map().size();
  problem_.first = n;
  problem_.problem.evaluate = [this](const Vector& y, double q) { return evaluate(y, q); };
  problem_.problem.wrap = Vector::Zero(n + 2);
  problem_.problem.wrap[n + 1] = period * kTurn;
  // A touch from outside, where the gap has a minimum, and one from within a contact, which a
  // maximum parts in two, are two things.
  problem_.proceed = [this](const BranchPoint& previous, const BranchPoint& here) {
    return push(previous) * push(here) > 0.0;
  };
}

StrobeGrazing::Place StrobeGrazing::place_of(double psi) const {
  const double whole = std::floor(psi / kTurn);
  const auto turn = static_cast<Eigen::Index>(whole) % period_;
  return {turn < 0 ? turn + period_ : turn, std::clamp(psi - whole * kTurn, 0.0, kTurn)};
}

Vector StrobeGrazing::pack(const Vector& turns, const StrobeTouch& touch, double first) const {
  Vector y(problem_.first + 2);
  y << turns, first / plane_.first_range(), static_cast<double>(touch.turn) * kTurn + touch.angle;
  return y;
}

std::vector<BranchPoint> StrobeGrazing::rewritings(const BranchPoint& point) const {
  const Eigen::Index size = problem_.first, n = plane_.map().size();
  std::vector<BranchPoint> list;
  for (Eigen::Index begun = 0; begun < size; begun += n) {
    const auto from_there = [&](const Vector& turns) {
      Vector turned(size);
      turned << turns.segment(begun, size - begun), turns.head(begun);
      return turned;
    };
    BranchPoint turned = point;
    turned.u.head(size) = from_there(point.u);
    turned.u[size + 1] -= static_cast<double>(begun / n) * kTurn;
    turned.tangent.head(size) = from_there(point.tangent);
    list.push_back(std::move(turned));
  }
  return list;
}

double StrobeGrazing::first_of(const BranchPoint& point) const {
  return point.u[problem_.first] * plane_.first_range();
}

StrobeTouch StrobeGrazing::touch_of(const BranchPoint& point) const {
  const Place place = place_of(point.u[problem_.first + 1]);
  const double pushed = std::abs(push(point));
  return {stop_, static_cast<std::size_t>(place.turn), place.angle,
          plane_.speed_unit() * std::sqrt(2.0 * kDepth * pushed)};
}

std::optional<ZeroEvaluation> StrobeGrazing::evaluate(const Vector& y, double second) const {
  const Eigen::Index n = problem_.first, m = plane_.map().size();
  const double first = y[n] * plane_.first_range();
  const Vector turns = y.head(n);
  const std::optional<PlaneEvaluation> orbit =
      plane_.problem(period_).evaluate(turns, first, second);
  if (!orbit) return {};
  const System* system = plane_.system_at(first, second);
  const std::array<const System*, 2> tangents{plane_.tangent_at(first, second, 0),
                                              plane_.tangent_at(first, second, 1)};
  const Place place = place_of(y[n + 1]);
  const auto at =
      plane_.map().within(*system, turns.segment(place.turn * m, m), place.angle, tangents);
  if (!at) return {};
  ZeroEvaluation zero{Vector(n + 2), Matrix::Zero(n + 2, n + 2), Vector(n + 2)};
  zero.residual.head(n) = orbit->residual;
  zero.jacobian.topLeftCorner(n, n) = orbit->jacobian + orbit->closing;
  zero.jacobian.col(n).head(n) = orbit->by_first * plane_.first_range();
  zero.jacobian.col(n + 1).head(n).setZero();
  zero.parameter_derivative.head(n) = orbit->by_second;
  const auto index = static_cast<std::size_t>(stop_);
  const Stop& stop = system->stops[index];
  const double length = plane_.length(), speed = plane_.speed_unit();
  zero.residual[n] = (stop.row.dot(at->state.q) - stop.gap) / length;
  zero.residual[n + 1] = stop.row.dot(at->state.qdot) / speed;
  zero.jacobian.row(n).segment(place.turn * m, m) = stop.row.transpose() * at->by_state.q / length;
  zero.jacobian.row(n + 1).segment(place.turn * m, m) =
      stop.row.transpose() * at->by_state.qdot / speed;
  zero.jacobian(n, n + 1) = stop.row.dot(at->by_angle.q) / length;
  zero.jacobian(n + 1, n + 1) = stop.row.dot(at->by_angle.qdot) / speed;
  for (const std::size_t k : {0u, 1u}) {
    const Stop& rate = tangents[k]->stops[index];
    const State& moved = at->by_parameters[k];
    const double depth = (stop.row.dot(moved.q) + rate.row.dot(at->state.q) - rate.gap) / length;
    const double approach = (stop.row.dot(moved.qdot) + rate.row.dot(at->state.qdot)) / speed;
    if (k == 0) {
      zero.jacobian(n, n) = depth * plane_.first_range();
      zero.jacobian(n + 1, n) = approach * plane_.first_range();
    } else {
      zero.parameter_derivative[n] = depth;
      zero.parameter_derivative[n + 1] = approach;
    }
  }
  return zero;
}

double StrobeGrazing::push(const BranchPoint& point) const {
  const Eigen::Index m = plane_.map().size();
  const System* system = plane_.system_at(first_of(point), point.parameter);
  if (!system) return 0.0;
  const Place place = place_of(point.u[problem_.first + 1]);
  const auto at = plane_.map().within(*system, point.u.segment(place.turn * m, m), place.angle, {});
  if (!at) return 0.0;
  return system->stops[static_cast<std::size_t>(stop_)].row.dot(at->by_angle.qdot) /
         plane_.speed_unit();
}

}  // namespace graze
