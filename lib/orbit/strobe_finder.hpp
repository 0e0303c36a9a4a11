// Finding the periodic orbits of structures on compliant stops: starts for strobe_orbit.hpp from
//
//   closed form   the (p, 1) orbits of rigid stops in their place, with the restitution that a
//                 contact of the same effective mass at the same speed has;
//   simulation    what the motion from the scene's initial state settles on;
//   random        rough guesses at impacts (rough_guess.hpp), followed through their contacts.
//
// A list is what these starts have found, never proved to be all there is.
#pragma once

#include <optional>

#include "graze/orbit/finder_values.hpp"

namespace graze {

// As find_orbits(), for a system with a compliant stop.
FoundOrbits find_strobe_orbits(const System& system, const std::optional<State>& start,
                               const FinderOptions& options);

}  // namespace graze
