// Branches of orbits on compliant stops over a parameter of the scene.
//
// Where the force of a stop sets in continuously a branch goes on smoothly through grazing contacts
// (GR), where one is born or lost. It is listed in parts, each of orbits with the same contacts,
// and each ends at its grazings. Where the force sets in with a jump the trace ends there as it
// may.
#pragma once

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_branches_values.hpp"

namespace graze {

// As trace_orbits() of orbit_branches.hpp, for a family with a compliant stop. Starts: those that
// find_orbits() gives at the scene's own value and at values spread over the range.
OrbitBranches trace_strobe_orbits(const SystemFamily& family, const BranchOptions& options);

}  // namespace graze
