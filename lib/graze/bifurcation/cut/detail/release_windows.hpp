// What lies beyond a CH: no single branch. The structure leaves its stop before it has come to rest
// there, after as many impacts as there was time for; one more of them fits in each of the windows
// that crowd up to CH, narrower from one to the next by a factor that depends on the restitution
// (1.25 at r = 0.8, 2.0 at 0.5), infinitely many. The orbits of the first ones are sought.
#pragma once

#include <vector>

#include "graze/bifurcation/problem/detail/passage_equations.hpp"

namespace graze {

// What leads to them: the impacts of solutions of the equations at the release, which go on beyond
// CH as motions that come near the stop instead of to rest on it; from `outer`, beyond the CH at
// `border`, on towards that. Each with the value of the parameter, farthest first; none where
// another stop holds the structure.
std::vector<OrbitBranchPoint> windows_beyond(const PassageEquations& equations,
                                             const ContinuationOptions& options,
                                             const SolutionPoint& border,
                                             const SolutionPoint& outer);

}  // namespace graze
