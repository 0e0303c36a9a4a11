// Branches of orbits as they are found, and as they are reported. A traced branch is judged point
// by point and divided at its boundaries into branches of orbits of the same kind; these are
// reported in an order and under names that do not depend on which start found them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "graze/bifurcation/trace/detail/branch_pieces.hpp"
#include "graze/bifurcation/trace/detail/components.hpp"

namespace graze {

// Where a special point of a branch leads.
struct SpecialContinuation {
  LaidOrbits* orbits = nullptr;            // whose equations it solves
  std::vector<OrbitBranchPoint> others{};  // as of BranchPlace
};

struct FoundBranch {
  OrbitBranch branch;
  std::vector<SpecialContinuation> continuations;  // of its special points
  int trace = 0;                                   // number of the trace that it is a part of
  int origin_branch = -1;          // index of the found branch that it was switched onto from
  std::size_t origin_special = 0;  // and of the special point there
};

// The branches that a trace, given as its pieces, is divided into. Pieces that lead beyond a
// boundary are cut off there.
std::vector<FoundBranch> branches_of(std::vector<BranchPiece>& pieces);

// Identifies the connected set of solutions that a branch belongs to; nullopt when it is not known.
using ConnectedSet = std::function<std::optional<std::pair<int, int>>(const OrbitBranch&)>;

// The branches by period, impacts and lowest parameter value, those that stick last, with their
// numbers, components, origins and the ids of their special points. `components` is empty before;
// names that `set_of` returns are not negative.
std::vector<OrbitBranch> put_in_order(std::vector<FoundBranch> found, Components components,
                                      const ConnectedSet& set_of);

}  // namespace graze
