// Where a branch of orbits that stick is left by another one: at PD by the doubled orbits, at BP by
// the branch that crosses.
#pragma once

#include <optional>

#include "graze/bifurcation/passage_equations.hpp"

namespace graze {

// An orbit a few steps along the branch that leaves at this special point, so that it can be told
// from the orbits of the known one. Nothing for other kinds, and where none is found.
std::optional<OrbitBranchPoint> orbit_beside(const PassageEquations& equations,
                                             const ContinuationOptions& options,
                                             const CriticalPoint& critical);

}  // namespace graze
