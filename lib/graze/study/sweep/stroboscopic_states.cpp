#include "graze/study/sweep/detail/stroboscopic_states.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "graze/base/angle.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {
namespace {

// Flies from the section's states to the starts of the following periods.
std::vector<State> flown_states(const System& system, const Orbit& orbit) {
  const OrbitSection& section = *orbit.section;
  const int periods = orbit.period / static_cast<int>(section.states.size());
  SegmentOptions options;
  options.closure_speed = section.closure_speed;
  std::vector<State> states;
  for (const MotionState<double>& from : section.states)
    for (int n = 1; n <= periods; ++n) {
      const TrajectorySegment segment = pass(system, from, {from.instant.period + n, 0.0}, options);
      states.push_back({segment.end.q, segment.end.qdot});
    }
  // The first of them starts the period after that of the section.
  const int first = (section.at.period_index + 1) % orbit.period;
  std::rotate(states.begin(), states.begin() + (orbit.period - first) % orbit.period, states.end());
  return states;
}

}  // namespace

std::vector<State> stroboscopic_states(const System& system, const Orbit& orbit) {
  if (orbit.section) return flown_states(system, orbit);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const std::vector<ImpactPoint> points = orbit.points();
  const double first = points.front().theta, whole = kTurn * orbit.period;
  std::vector<State> states;
  for (int n = 0; n < orbit.period; ++n) {
    // The phase of the instant, counted on from the orbit's first impact.
    double theta = system.forcing()->phase + kTurn * n;
    theta -= whole * std::floor((theta - first) / whole);
    std::size_t i = points.size();
    while (i > 1 && points[i - 1].theta > theta) --i;
    const ImpactPoint& last = points[i - 1];
    const auto hit = static_cast<std::size_t>(orbit.impacts[i - 1].stop);
    const State after = after_impact(system.stops[hit], last.before);
    arc.start(last.theta, after.q, after.qdot);
    State state{Vector(system.modes()), Vector(system.modes())};
    arc.state((theta - last.theta) / flow.frequency(), state.q, state.qdot);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace graze
