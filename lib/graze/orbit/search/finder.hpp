// Finding the periodic orbits of a scene's system from several independent starts.
//
//   closed form   both (p, 1) solutions on each stop, exactly (closed_form.hpp), and all (p, 2)
//                 solutions on each pair of stops of constant restitution (two_impacts.hpp);
//   simulation    what the motion from the scene's initial state settles on, whatever its pattern;
//   random        for each other pattern the phase problem (phase_problem.hpp) searched from quasi-
//                 random phases, known solutions deflated, and by global minimisation where that
//                 leaves no orbit (phase_search.hpp). Where the phase problem does not hold (a mode
//                 whose free motion repeats by itself), Levenberg-Marquardt on the shooting
//                 equations from rough guesses.
//
// With compliant stops the first and the last are those of contact_starts.hpp, and every orbit is
// followed through its contacts (followed_orbit.hpp).
//
// Newton's method on the shooting equations polishes each solution, and the recomputed residual is
// the judge. The list holds what was found within the budgets; it is not proved to be complete.
#pragma once

#include <optional>

#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/finder_values.hpp"

namespace graze {

// Finds orbits. Requires forcing and a stop; finding none is an empty list. Without a start there
// is no simulation.
FoundOrbits find_orbits(const System& system, const std::optional<State>& start,
                        const FinderOptions& options);

}  // namespace graze
