// Branches with enough points for a smooth curve of a quantity.
#pragma once

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/trace/orbit_branches_values.hpp"

namespace graze {

// As trace_orbits(family, options), with points added until the curve of `shown`, a number that is
// drawn, is accurate to a pixel; none are added if it is empty.
OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options,
                           const OrbitNumber& shown);

}  // namespace graze
