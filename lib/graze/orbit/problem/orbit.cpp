#include "graze/orbit/problem/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/motion/detail/clearance.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

// The smallest gap of another stop at the instant of an impact that turns the motion back from it
// too, if below `lowest`: a corner of that gap, and no minimum of any flight. Stops that are
// touched together are hit together.
std::optional<NearestApproach> lowest_corner(const System& system, const ImpactPattern& pattern,
                                             const ImpactPoint& point, const State& after,
                                             std::size_t flight, double lowest) {
  std::optional<NearestApproach> nearest;
  const Stop& stop = stop_of(system, pattern, flight);
  for (std::size_t k = 0; k < system.stops.size(); ++k) {
    if (static_cast<int>(k) == pattern.stops[flight]) continue;
    const Stop& other = system.stops[k];
    if (other.row.dot(point.before.qdot) < 0.0 || other.row.dot(after.qdot) > 0.0) continue;
    if (other.gap == stop.gap && other.row == stop.row) continue;  // hit together
    const GapValue<double> gap = gap_value<double>(other.row, point.before.q, other.gap);
    const double value = std::abs(gap.value) <= gap.rounding ? 0.0 : gap.value;
    if (!(value < lowest)) continue;
    lowest = value;
    nearest = NearestApproach{flight, static_cast<int>(k), 0.0, value};
  }
  return nearest;
}

}  // namespace

std::vector<OrbitImpact> ordered_impacts(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& points) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (wrapped(points[i].theta) < wrapped(points[first].theta)) first = i;
  const double origin = points[first].theta - wrapped(points[first].theta);
  std::vector<OrbitImpact> impacts;
  for (std::size_t m = 0; m < points.size(); ++m) {
    const std::size_t i = (first + m) % points.size();
    const double lap = i < first ? kTurn * pattern.period : 0.0;
    const double theta = points[i].theta + lap - origin;
    const double phase = wrapped(theta);
    impacts.push_back({pattern.stops[i], static_cast<int>(std::lround((theta - phase) / kTurn)),
                       phase, stop_of(system, pattern, i).row.dot(points[i].before.qdot),
                       points[i].before});
  }
  return impacts;
}

System Orbit::timed(const System& system) const {
  System own = system;
  if (lasts) own.modal().forcing->frequency = kTurn * period / *lasts;
  return own;
}

ImpactPattern Orbit::pattern() const {
  ImpactPattern result{period, {}};
  for (const OrbitImpact& impact : impacts) result.stops.push_back(impact.stop);
  return result;
}

std::vector<ImpactPoint> Orbit::points() const {
  std::vector<ImpactPoint> result;
  for (const OrbitImpact& impact : impacts)
    result.push_back({impact.phase + kTurn * impact.period_index, impact.before});
  return result;
}

bool Orbit::in_order() const {
  const std::vector<ImpactPoint> met = points();
  for (std::size_t i = 1; i < met.size(); ++i)
    if (met[i].theta < met[i - 1].theta) return false;
  return met.empty() || met.back().theta <= met.front().theta + kTurn * period;
}

const OrbitImpact& leading_impact(const Orbit& orbit) {
  if (!orbit.sticks()) return orbit.impacts.front();
  return *std::max_element(
      orbit.impacts.begin(), orbit.impacts.end(),
      [](const OrbitImpact& a, const OrbitImpact& b) { return a.speed < b.speed; });
}

Admissibility admissibility(const System& system, const ImpactPattern& pattern,
                            const std::vector<ImpactPoint>& points) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const double still = still_speed(system);
  constexpr double kUnfinished = -std::numeric_limits<double>::infinity();
  double lowest = std::numeric_limits<double>::infinity();
  Admissibility result;
  result.admissible = true;
  result.smallest_speed = result.shortest_flight = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Stop& stop = stop_of(system, pattern, i);
    const double speed = stop.row.dot(points[i].before.qdot);
    if (speed < result.smallest_speed) {
      result.smallest_speed = speed;
      result.slowest = i;
    }
    const double flight = flight_time(system, pattern, points, i);
    result.shortest_flight = std::min(result.shortest_flight, flight);
    if (!(speed > still) || !(flight > 0.0)) result.admissible = false;
    const State after = after_impact(stop, points[i].before);
    if (stop.restitution().at(speed) == 0.0)
      result.push = std::max(result.push.value_or(-std::numeric_limits<double>::infinity()),
                             stop.row.dot(vector_field(system, after, points[i].theta).qdot));
    if (const auto corner = lowest_corner(system, pattern, points[i], after, i, lowest)) {
      lowest = corner->gap;
      result.nearest = corner;
    }
    // When one search could not be finished, the others do not matter.
    if (!(flight > 0.0) || lowest == kUnfinished) continue;
    arc.start(points[i].theta, after.q, after.qdot);
    for (std::size_t k = 0; k < system.stops.size(); ++k) {
      const bool here = static_cast<int>(k) == pattern.stops[i];
      const ArcCurve<double> curve(
          arc, gap_observable<double>(system.stops[k].row, system.stops[k].gap), flight, here);
      const std::optional<GapMinimum> minimum = lowest_minimum(curve, 0, lowest);
      if (!minimum) continue;
      lowest = minimum->gap;
      result.nearest = NearestApproach{i, static_cast<int>(k), minimum->s, minimum->gap};
      if (lowest == kUnfinished) break;
    }
  }
  if (result.nearest && result.nearest->gap < 0.0) result.admissible = false;
  if (result.push && *result.push > 0.0) result.admissible = false;
  return result;
}

Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution) {
  return make_orbit(system, problem, solution,
                    orbit_multipliers(system, problem.pattern(), problem.unpack(system, solution)));
}

Orbit make_orbit(const System& system, const ShootingProblem& problem, const Vector& solution,
                 std::vector<Eigenvalue> multipliers) {
  const std::vector<ImpactPoint> points = problem.unpack(system, solution);
  Orbit orbit;
  orbit.period = problem.pattern().period;
  orbit.impacts = ordered_impacts(system, problem.pattern(), points);
  orbit.residual = problem.residual(system, solution).cwiseAbs().maxCoeff();
  orbit.multipliers = std::move(multipliers);
  orbit.stable = stability(orbit.multipliers);
  const Admissibility classification = admissibility(system, problem.pattern(), points);
  orbit.admissible = classification.admissible;
  orbit.clearance = classification.clearance();
  return orbit;
}

}  // namespace graze
