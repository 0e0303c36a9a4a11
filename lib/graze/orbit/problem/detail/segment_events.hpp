// The events of segments from section to section as those of one orbit: what lasts over a section
// is put together again.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/grazing_contact.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// A grazing contact, where an orbit has one.
struct MetGrazing {
  GrazingContact grazing;
  Instant<double> at;  // counted within its segment
  State state;
};

// Adds the impacts and the stuck phases to the orbit, in time order, and tells where the first of
// its section's states lies. `periods`: of each segment.
void add_events(const System& system, const std::vector<TrajectorySegment>& segments, int periods,
                const std::optional<MetGrazing>& grazing, Orbit& orbit);

}  // namespace graze
