// The events of passages from section to section as those of one orbit: what lasts over a section
// is put together again.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/touch.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// A touch, where an orbit has one.
struct MetTouch {
  Touch touch;
  Instant<double> at;  // counted within its passage
  State state;
};

// Adds the impacts and the stuck phases to the orbit, in time order, and tells where the first of
// its section's states lies. `periods`: of each passage.
void add_events(const System& system, const std::vector<Passage>& passages, int periods,
                const std::optional<MetTouch>& touch, Orbit& orbit);

}  // namespace graze
