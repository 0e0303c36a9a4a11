// A connected set of solutions of the shooting equations, judged point by point and divided at its
// grazings into the parts that are orbits of the system.
#pragma once

#include <vector>

#include "graze/bifurcation/orbit_equations.hpp"

namespace graze {

// What an end, and a special point, of a traced branch are called where it is one of orbits.
OrbitBranchEnd as_orbit_end(BranchEnd end);
// Whether a special point of the equations is one of orbits too: where branches of orbits cross, a
// multiplier is 1. Beside a grazing of orbits that stick the map's derivative jumps, and the
// orientation with it; and where an amplitude passes zero, orbits shrink to a point of rest that is
// a solution at every phase.
bool is_of_orbits(const CriticalPoint& critical);
SpecialKind as_special(CriticalKind kind);

// The branches that a traced component consists of: its admissible parts, each ended by the grazing
// where it stops being an orbit, or with `keep_virtual` the whole in one piece, its grazings among
// the special points.
std::vector<OrbitBranch> orbit_parts(const OrbitEquations& equations,
                                     const ContinuationOptions& options, const Branch& branch,
                                     bool keep_virtual);

}  // namespace graze
