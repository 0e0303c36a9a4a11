// A connected set of solutions of the shooting equations, judged point by point and divided at its
// grazings into the parts that are orbits of the system.
#pragma once

#include <vector>

#include "graze/bifurcation/orbit_equations.hpp"

namespace graze {

// The branches that a traced component consists of: its admissible parts, each ended by the grazing
// where it stops being an orbit, or with `keep_virtual` the whole in one piece, its grazings among
// the special points.
std::vector<OrbitBranch> orbit_parts(const OrbitEquations& equations,
                                     const ContinuationOptions& options, const Branch& branch,
                                     bool keep_virtual);

}  // namespace graze
