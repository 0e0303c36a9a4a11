#include "graze/bifurcation/problem/grazing_orbit.hpp"

#include <cstddef>

#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

std::optional<GrazingOrbit> with_grazing(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& impacts) {
  const Admissibility classification = admissibility(system, pattern, impacts);
  if (!classification.nearest) return {};
  const NearestApproach& approach = *classification.nearest;
  const ImpactPoint& from = impacts[approach.flight];
  const ExactFlow<double> flow(system);
  const Transition arc =
      transition(system, flow, after_impact(stop_of(system, pattern, approach.flight), from.before),
                 from.theta, approach.after);
  GrazingOrbit orbit{pattern, impacts, approach.flight + 1};
  const auto at = static_cast<std::ptrdiff_t>(orbit.grazing);
  orbit.impacts.insert(orbit.impacts.begin() + at,
                       {from.theta + approach.after * system.forcing()->frequency, arc.end});
  orbit.pattern.stops.insert(orbit.pattern.stops.begin() + at, approach.stop);
  return orbit;
}

GrazingOrbit without_grazing(GrazingOrbit orbit) {
  const auto at = static_cast<std::ptrdiff_t>(orbit.grazing);
  orbit.impacts.erase(orbit.impacts.begin() + at);
  orbit.pattern.stops.erase(orbit.pattern.stops.begin() + at);
  return orbit;
}

}  // namespace graze
