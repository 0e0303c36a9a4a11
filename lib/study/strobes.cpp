#include "graze/study/strobes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "graze/base/angle.hpp"
#include "graze/flow/exact_flow.hpp"
#include "graze/orbit/passage.hpp"

namespace graze {
namespace {

// Flown from the orbit's section.
std::vector<State> sticking_states(const System& system, const Orbit& orbit) {
  const MotionState<double>& section = orbit.sticking->at_section;
  PassageOptions options;
  options.closure_speed = orbit.sticking->closure_speed;
  std::vector<State> states;
  for (int n = 1; n <= orbit.period; ++n) {
    const Passage passage = pass(system, section, {section.instant.period + n, 0.0}, options);
    states.push_back({passage.end.q, passage.end.qdot});
  }
  // The first of them starts the period after that of the section.
  const int first = (orbit.sticking->section.period_index + 1) % orbit.period;
  std::rotate(states.begin(), states.begin() + (orbit.period - first) % orbit.period, states.end());
  return states;
}

// Flown on from the section of each turn, to the start of the next period.
std::vector<State> compliant_states(const System& system, const Orbit& orbit) {
  PassageOptions options;
  options.closure_speed = orbit.strobe->closure_speed;
  std::vector<State> states;
  for (const MotionState<double>& turn : orbit.strobe->turns) {
    const Passage passage = pass(system, turn, {turn.instant.period + 1, 0.0}, options);
    states.push_back({passage.end.q, passage.end.qdot});
  }
  std::rotate(states.begin(), std::prev(states.end()), states.end());
  return states;
}

}  // namespace

std::vector<State> stroboscopic_states(const System& system, const Orbit& orbit) {
  if (orbit.strobe) return compliant_states(system, orbit);
  if (orbit.sticking) return sticking_states(system, orbit);
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
