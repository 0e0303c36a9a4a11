// Orbits of period 1 on compliant stops, searched for from the response that meets no stop.
//
// All gaps are widened until that response is clear of every stop, where it is the only periodic
// motion near, in closed form. From there the branch of solutions is followed over the widening,
// through its grazings and folds; where it passes the system's own gaps it gives those orbits that
// are connected to the linear response, whatever their stability and the length of their contacts.
#pragma once

#include <optional>

#include "graze/orbit/search/finder_values.hpp"

namespace graze {

// The result of find_orbits() of finder.hpp, and for a system with compliant stops also these
// orbits, where orbits of period 1 from closed forms are wanted. A note says when the structure has
// too many modes for that.
FoundOrbits search_orbits(const System& system, const std::optional<State>& start,
                          const FinderOptions& options);

}  // namespace graze
