// A branch of orbits, traced in pieces: where a contact that begins or ends with a jump of the
// derivative comes near the stroboscopic section, at which the equations would have a corner though
// nothing happens to the orbits, the section moves away from all of them and the branch goes on
// from there.
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

// The same orbits in clearer equations (OrbitProblem::clearer); null where they are clear.
using Clearer = std::function<LaidOrbits*(const LaidOrbits& orbits, const SolutionPoint& solution)>;

// In order along the branch; each piece but the first begins with the orbit that the one before it
// ends with. Its solutions go on as its boundaries allow; its period is not halved but at the ends.
std::vector<BranchPiece> trace_pieces(const Clearer& clearer, LaidOrbits& orbits,
                                      const ContinuationOptions& options,
                                      const SolutionPoint& start, Directions directions);

}  // namespace graze
