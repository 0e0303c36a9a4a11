// All branches of periodic orbits over a parameter of the scene: starts are searched for, each
// branch is traced to its ends, with the stability and admissibility of every point, and special
// points are switched at. The equations of the orbits depend on their layout (orbit_problem.hpp).
#pragma once

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/trace/orbit_branches_values.hpp"

namespace graze {

// Traces every branch of (p, k) orbits that the starts lead to, and with `follow_depth` those that
// are connected to them. Without `keep_virtual` a branch ends at the grazing beyond which solutions
// are virtual. Throws InputError for options that cannot be used: an empty range, a negative step,
// impacts of -1.
OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options);

}  // namespace graze
