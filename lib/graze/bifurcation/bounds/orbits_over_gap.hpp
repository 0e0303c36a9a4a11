// Orbits of period 1 on compliant stops, sought from the response that meets no stop.
//
// All gaps are widened until that response is clear of every stop, where it is the only periodic
// motion near, in closed form. From there the branch of solutions is followed over the widening,
// through its grazings and folds; where it passes the system's own gaps it passes its orbits: those
// that are joined to the linear response, whatever their stability and however long their contacts.
#pragma once

#include <optional>

#include "graze/orbit/search/finder_values.hpp"

namespace graze {

// find_orbits() of finder.hpp, and for a system with compliant stops these besides, where orbits of
// period 1 are asked for from closed forms. Where the structure has too many modes for that a note
// says so.
FoundOrbits search_orbits(const System& system, const std::optional<State>& start,
                          const FinderOptions& options);

}  // namespace graze
