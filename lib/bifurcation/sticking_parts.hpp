// A traced branch of orbits that stick as its orbits, special points and ends.
#pragma once

#include <optional>
#include <vector>

#include "graze/bifurcation/sticking_branches.hpp"

namespace graze {

// The branch that was traced with these equations. Nothing where a point of it cannot be judged.
// Adds what lies beyond its ends, and where it `switches` the orbits of other branches that leave
// it at PD and BP.
std::optional<OrbitBranch> judge_sticking(const StickingEquations& equations,
                                          const ContinuationOptions& options, const Branch& branch,
                                          bool switches,
                                          std::vector<StickingNeighbour>& neighbours);

}  // namespace graze
