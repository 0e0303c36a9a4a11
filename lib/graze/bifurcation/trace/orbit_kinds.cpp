#include "graze/bifurcation/trace/detail/orbit_kinds.hpp"

#include "graze/bifurcation/cut/detail/flight_borders.hpp"
#include "graze/bifurcation/cut/detail/flight_locus.hpp"
#include "graze/bifurcation/cut/detail/passage_locus.hpp"
#include "graze/bifurcation/cut/detail/release_borders.hpp"
#include "graze/bifurcation/cut/detail/touch_borders.hpp"

namespace graze {

std::unique_ptr<BranchBorders> borders_of(const OrbitProblem& problem,
                                          const ContinuationOptions& continuation,
                                          const BranchOptions& options) {
  if (const auto* flights = dynamic_cast<const FlightEquations*>(&problem))
    return std::make_unique<FlightBorders>(*flights, continuation, options);
  const auto& passages = dynamic_cast<const PassageEquations&>(problem);
  if (passages.layout().released)
    return std::make_unique<ReleaseBorders>(passages, continuation, options.follow_depth > 0);
  return std::make_unique<TouchBorders>(passages, continuation);
}

std::unique_ptr<LocusOrbits> orbits_along(const OrbitProblem& problem) {
  if (const auto* flights = dynamic_cast<const FlightEquations*>(&problem))
    return std::make_unique<FlightLocus>(*flights);
  const auto& passages = dynamic_cast<const PassageEquations&>(problem);
  if (passages.layout().released) return std::make_unique<ReleaseLocus>(passages);
  return std::make_unique<FixedPhaseLocus>(passages);
}

}  // namespace graze
