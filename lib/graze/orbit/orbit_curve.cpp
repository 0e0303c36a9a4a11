#include "graze/orbit/detail/orbit_curve.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/flow/held/detail/exact_phase.hpp"
#include "graze/flow/held/detail/held_exactly.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {
namespace {

// The arcs of a whole orbit, some of which begin at an impact, as flights that all do; `whole`: its
// periods, rad. Every flight begins within them, the one of the smallest phase first.
std::vector<std::vector<CurveSample>> from_impact_to_impact(
    const std::vector<std::vector<CurveSample>>& arcs, const std::vector<bool>& begins_at_impact,
    double whole) {
  std::vector<std::vector<CurveSample>> flights;
  std::vector<CurveSample> head;  // up to the first impact: the end of the last flight
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (begins_at_impact[i]) flights.emplace_back();
    std::vector<CurveSample>& into = flights.empty() ? head : flights.back();
    into.insert(into.end(), arcs[i].begin(), arcs[i].end());
  }
  if (flights.empty()) return {head};
  for (CurveSample& sample : head) {
    sample.theta += whole;
    flights.back().push_back(sample);
  }
  for (std::vector<CurveSample>& flight : flights) {
    const double turn = whole * std::floor(flight.front().theta / whole);
    for (CurveSample& sample : flight) sample.theta -= turn;
  }
  const auto first = std::min_element(
      flights.begin(), flights.end(),
      [](const auto& a, const auto& b) { return a.front().theta < b.front().theta; });
  std::rotate(flights.begin(), first, flights.end());
  return flights;
}

}  // namespace

std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  const MeasuredRow& seen, int per_period) {
  const double frequency = orbit.timed(system).forcing()->frequency;
  // The hops of a chatter are short and still curves, and so are contacts.
  const double least = orbit.section ? 12.0 : 1.0;
  State state{Vector(system.modes()), Vector(system.modes())};
  std::vector<std::vector<CurveSample>> flights;
  OrbitListeners listeners;
  listeners.flight = [&](const ContactPhase<double>& phase, double theta, double seconds) {
    const double turn = frequency * seconds;
    const int count = static_cast<int>(std::fmax(least, std::ceil(turn / kTurn * per_period)));
    flights.emplace_back();
    for (int k = 0; k <= count; ++k) {
      phase.state(seconds * k / count, state.q, state.qdot);
      const double at = theta + turn * k / count;
      flights.back().push_back({at, seen.row.dot(state.q) + seen.carried_at(at),
                                seen.row.dot(state.qdot) + seen.carried_rate(at)});
    }
  };
  const std::vector<bool> begins_at_impact = fly_orbit(system, orbit, listeners);
  return from_impact_to_impact(flights, begins_at_impact, kTurn * orbit.period);
}

namespace {

bool begins_at_impact(const TrajectorySegment& segment, const Instant<double>& at) {
  const auto there = [&at](const Instant<double>& impact) {
    return impact.period == at.period && impact.local == at.local;
  };
  return std::any_of(segment.impacts.begin(), segment.impacts.end(),
                     [&](const SegmentImpact& impact) { return there(impact.at); }) ||
         std::any_of(segment.contacts.begin(), segment.contacts.end(),
                     [&](const SegmentContact& c) { return !c.from_start && there(c.from); });
}

std::vector<bool> fly_segments(const System& system, const Orbit& orbit,
                               const OrbitListeners& listeners) {
  const OrbitSection& section = *orbit.section;
  const long long periods = orbit.period / static_cast<long long>(section.states.size());
  const double frequency = system.forcing()->frequency;
  double theta = section.at.phase + kTurn * section.at.period_index;
  std::vector<Instant<double>> starts;
  SegmentOptions options;
  options.closure_speed = section.closure_speed;
  options.flight = [&](const ContactPhase<double>& phase, const Instant<double>& at,
                       double seconds) {
    starts.push_back(at);
    listeners.flight(phase, theta, seconds);
    theta += frequency * seconds;
  };
  options.impact = listeners.impact;
  options.closure = listeners.closure;
  std::vector<bool> begins;
  for (const MotionState<double>& state : section.states) {
    starts.clear();
    const TrajectorySegment segment =
        pass(system, state, {state.instant.period + periods, state.instant.local}, options);
    for (const Instant<double>& at : starts) begins.push_back(begins_at_impact(segment, at));
  }
  return begins;
}

}  // namespace

std::vector<bool> fly_orbit(const System& system, const Orbit& orbit,
                            const OrbitListeners& listeners) {
  if (orbit.lasts) {
    Orbit same = orbit;
    same.lasts.reset();
    return fly_orbit(orbit.timed(system), same, listeners);
  }
  if (orbit.section && (orbit.meets_stops() || !system.frictions.empty()))
    return fly_segments(system, orbit, listeners);
  // Of several loads, or damping that couples modes, too.
  const std::unique_ptr<ExactPhase<double>> phase = exact_phase(system, {});
  if (orbit.section) {
    // The free motion alone, in closed form: a stop that it touches does not change it.
    const OrbitSection& section = *orbit.section;
    const MotionState<double>& start = section.states.front();
    phase->start(section.at.phase, start.q, start.qdot, 0.0);
    listeners.flight(*phase, section.at.phase, orbit.period * system.period());
    return {false};
  }
  const std::vector<ImpactPoint> points = orbit.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double next =
        i + 1 < points.size() ? points[i + 1].theta : points.front().theta + kTurn * orbit.period;
    const OrbitImpact& impact = orbit.impacts[i];
    const Stop& stop = system.stops[static_cast<std::size_t>(impact.stop)];
    if (listeners.impact)
      listeners.impact(
          {{impact.stop, impact.speed, 0.0, stop.restitution().jump(impact.speed), true}});
    const State after = after_impact(stop, points[i].before);
    phase->start(points[i].theta, after.q, after.qdot, 0.0);
    listeners.flight(*phase, points[i].theta,
                     (next - points[i].theta) / system.forcing()->frequency);
  }
  return std::vector<bool>(points.size(), true);
}

}  // namespace graze
