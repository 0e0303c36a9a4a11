// A traced branch of solutions of the equations of orbits that stick, judged: its orbits, their
// special points, how it ends, and what lies beyond.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/bifurcation/passage_equations.hpp"

namespace graze {

// An orbit beyond the CH or GR that ends a branch, or on the one that leaves it at a PD or BP.
struct StickingNeighbour {
  std::size_t special = 0;  // index of that among the branch's special points
  Orbit orbit;
  double value = 0.0;  // of the parameter
};

struct StickingVerdict {
  OrbitBranch branch;
  std::vector<StickingNeighbour> neighbours;
};

// The branch that was traced with these equations; `switches`: whether orbits of other branches
// that leave it at PD and BP are sought. Nothing where a point of it cannot be judged.
std::optional<StickingVerdict> judge_sticking(const PassageEquations& equations,
                                              const ContinuationOptions& options,
                                              const Branch& branch, bool switches);

}  // namespace graze
