#include "graze/study/strobes.hpp"

#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/flow/exact_flow.hpp"

namespace graze {

std::vector<State> stroboscopic_states(const System& system, const Orbit& orbit) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const std::vector<ImpactPoint> points = orbit.points();
  const double first = points.front().theta, whole = kTurn * orbit.period;
  std::vector<State> states;
  for (int n = 0; n < orbit.period; ++n) {
    // The phase of the instant, counted on from the orbit's first impact.
    double theta = system.forcing->phase + kTurn * n;
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
