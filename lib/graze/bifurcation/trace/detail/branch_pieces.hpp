// A branch of orbits, traced in pieces: where a contact that begins or ends with a jump of the
// derivative comes near the stroboscopic section, the equations would have a corner although
// nothing happens to the orbits. There the section is moved away from all such contacts and the
// branch goes on from there.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/problem/detail/orbit_problem.hpp"

namespace graze {

// The orbits of one layout, to be traced.
struct LaidOrbits {
  std::unique_ptr<OrbitProblem> problem;
  std::unique_ptr<BranchBoundaries> boundaries;
  double closure_speed = 0.0;  // m/s, by which their chatters are closed

  OrbitProblem* operator->() const { return problem.get(); }
};

struct BranchPiece {
  LaidOrbits* orbits;
  Branch branch;
};

// The same orbits on clearer sections (OrbitProblem::clearer); null where they are clear.
using Clearer = std::function<LaidOrbits*(const LaidOrbits& orbits, const SolutionPoint& solution)>;

// In order along the branch; each piece but the first begins with the orbit at which the previous
// one ends. Its solutions extend as far as its boundaries allow; only at the ends may the period be
// halved.
std::vector<BranchPiece> trace_pieces(const Clearer& clearer, LaidOrbits& orbits,
                                      const ContinuationOptions& options,
                                      const SolutionPoint& start, Directions directions);

}  // namespace graze
