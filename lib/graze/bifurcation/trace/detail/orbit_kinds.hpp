// Selects by the layout of orbits, prescribed flights or segments that are followed, the boundaries
// of their branches and their properties along a locus. The only place where this is decided.
#pragma once

#include <memory>

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/detail/orbit_problem.hpp"

namespace graze {

// For orbits over one parameter. Refers to both arguments.
std::unique_ptr<BranchBoundaries> boundaries_of(const OrbitProblem& problem,
                                                const ContinuationOptions& continuation,
                                                const BranchOptions& options);

// For orbits over two parameters. Refers to the problem.
std::unique_ptr<LocusOrbits> orbits_along(const OrbitProblem& problem);

}  // namespace graze
