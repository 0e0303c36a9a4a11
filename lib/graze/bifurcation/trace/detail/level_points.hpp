// The points of a branch at which numbers of its orbits take given values, or are extreme.
#pragma once

#include <memory>
#include <vector>

#include "graze/bifurcation/problem/orbit_level.hpp"
#include "graze/bifurcation/trace/detail/branch_pieces.hpp"

namespace graze {

// Adds them to the critical points of a traced branch; of levels that end it there are none.
void mark_levels(const LaidOrbits& orbits, const ContinuationOptions& options,
                 const std::vector<OrbitLevel>& levels, Branch& branch);

// The same boundaries, and those levels that end a branch; as they are where there are none. Refers
// to the levels.
std::unique_ptr<BranchBoundaries> with_level_ends(std::unique_ptr<BranchBoundaries> boundaries,
                                                  const OrbitProblem& problem,
                                                  const ContinuationOptions& options,
                                                  const std::vector<OrbitLevel>& levels);

}  // namespace graze
