// A traced branch, judged point by point and divided at its boundaries into branches of orbits of
// the same kind.
#pragma once

#include <vector>

#include "graze/bifurcation/trace/detail/branch_pieces.hpp"

namespace graze {

// What a special point of a branch leads to.
struct SpecialContinuation {
  LaidOrbits* orbits = nullptr;            // whose equations it solves
  std::vector<OrbitBranchPoint> others{};  // as of BranchPlace
};

struct BranchPart {
  OrbitBranch branch;
  std::vector<SpecialContinuation> continuations;  // of its special points
};

// The parts to be listed. Pieces that extend beyond a boundary are cut off there.
std::vector<BranchPart> parts_of(std::vector<BranchPiece>& pieces);

}  // namespace graze
