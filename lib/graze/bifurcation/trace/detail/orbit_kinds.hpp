// What differs with the motion between the nodes of a layout, flights that are prescribed or
// segments that are followed: where branches of its orbits are cut, and what its orbits are along a
// locus. The one place where that is asked.
#pragma once

#include <memory>

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/detail/orbit_problem.hpp"

namespace graze {

// Of orbits over one parameter. Refers to both.
std::unique_ptr<BranchBoundaries> boundaries_of(const OrbitProblem& problem,
                                                const ContinuationOptions& continuation,
                                                const BranchOptions& options);

// Of orbits over two parameters, to which it refers.
std::unique_ptr<LocusOrbits> orbits_along(const OrbitProblem& problem);

}  // namespace graze
