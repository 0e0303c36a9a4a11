#include "graze/bifurcation/trace/detail/orbit_kinds.hpp"

#include "graze/bifurcation/cut/detail/contact_boundaries.hpp"
#include "graze/bifurcation/cut/detail/flight_boundaries.hpp"
#include "graze/bifurcation/cut/detail/flight_locus.hpp"
#include "graze/bifurcation/cut/detail/release_boundaries.hpp"
#include "graze/bifurcation/cut/detail/response_boundaries.hpp"
#include "graze/bifurcation/cut/detail/response_locus.hpp"
#include "graze/bifurcation/cut/detail/segment_locus.hpp"

namespace graze {

std::unique_ptr<BranchBoundaries> boundaries_of(const OrbitProblem& problem,
                                                const ContinuationOptions& continuation,
                                                const BranchOptions& options) {
  if (const auto* flights = dynamic_cast<const FlightEquations*>(&problem))
    return std::make_unique<FlightBoundaries>(*flights, continuation, options);
  if (const auto* response = dynamic_cast<const ResponseEquations*>(&problem))
    return std::make_unique<ResponseBoundaries>(*response, continuation, options);
  const auto& segments = dynamic_cast<const SegmentEquations&>(problem);
  if (segments.layout().released)
    return std::make_unique<ReleaseBoundaries>(segments, continuation, options.follow_depth > 0);
  return std::make_unique<ContactBoundaries>(segments, continuation);
}

std::unique_ptr<LocusOrbits> orbits_along(const OrbitProblem& problem) {
  if (const auto* flights = dynamic_cast<const FlightEquations*>(&problem))
    return std::make_unique<FlightLocus>(*flights);
  if (const auto* response = dynamic_cast<const ResponseEquations*>(&problem))
    return std::make_unique<ResponseLocus>(*response);
  const auto& segments = dynamic_cast<const SegmentEquations&>(problem);
  if (segments.layout().released) return std::make_unique<ReleaseLocus>(segments);
  return std::make_unique<FixedPhaseLocus>(segments);
}

}  // namespace graze
