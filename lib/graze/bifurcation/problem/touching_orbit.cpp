#include "graze/bifurcation/problem/touching_orbit.hpp"

#include <cstddef>

#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

std::optional<TouchingOrbit> with_touch(const System& system, const ImpactPattern& pattern,
                                        const std::vector<ImpactPoint>& impacts) {
  const Admissibility verdict = admissibility(system, pattern, impacts);
  if (!verdict.nearest) return {};
  const NearestApproach& approach = *verdict.nearest;
  const ImpactPoint& from = impacts[approach.flight];
  const ExactFlow<double> flow(system);
  const Transition arc =
      transition(system, flow, after_impact(stop_of(system, pattern, approach.flight), from.before),
                 from.theta, approach.after);
  TouchingOrbit orbit{pattern, impacts, approach.flight + 1};
  const auto at = static_cast<std::ptrdiff_t>(orbit.touch);
  orbit.impacts.insert(orbit.impacts.begin() + at,
                       {from.theta + approach.after * system.forcing()->frequency, arc.end});
  orbit.pattern.stops.insert(orbit.pattern.stops.begin() + at, approach.stop);
  return orbit;
}

TouchingOrbit without_touch(TouchingOrbit orbit) {
  const auto at = static_cast<std::ptrdiff_t>(orbit.touch);
  orbit.impacts.erase(orbit.impacts.begin() + at);
  orbit.pattern.stops.erase(orbit.pattern.stops.begin() + at);
  return orbit;
}

}  // namespace graze
