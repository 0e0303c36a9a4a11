// All branches of one impact pattern that have been traced so far: what lies on them need not be
// traced again.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "graze/bifurcation/canonical_pattern.hpp"
#include "graze/bifurcation/orbit_parts.hpp"
#include "graze/bifurcation/special_orbit.hpp"

namespace graze {

class PatternBranches {
 public:
  // `range` says from where to where, how fast, and when to stop; `keep_virtual`: whether solutions
  // that are no orbits are listed too.
  PatternBranches(const SystemFamily& family, ImpactPattern pattern, const MotionScale& scale,
                  ContinuationOptions range, bool keep_virtual);
  PatternBranches(const PatternBranches&) = delete;
  PatternBranches& operator=(const PatternBranches&) = delete;

  const OrbitEquations& equations() const { return equations_; }
  const ContinuationOptions& options() const { return options_; }
  int traces() const { return static_cast<int>(traced_.size()); }

  // The solution near these impacts at a value; nothing where there is none.
  std::optional<BranchPoint> solve(const std::vector<ImpactPoint>& impacts, double value) const;
  // The same where the branch may turn back, as at a special point. `along`: its direction, where
  // that is known.
  std::optional<BranchPoint> solve_near(const std::vector<ImpactPoint>& impacts, double value,
                                        const std::optional<SpecialOrbit::Direction>& along) const;
  // A branch point as it stands, where no equations are regular, with the direction of one branch.
  BranchPoint crossing(const std::vector<ImpactPoint>& impacts, double value,
                       const SpecialOrbit::Direction& along) const;
  // Whether a solution is listed: an orbit of the system, or virtual ones are asked for.
  bool lists(const BranchPoint& solution) const;
  // Whether the solution lies on a branch that has been traced, wherever its period begins.
  bool knows(const BranchPoint& solution) const;
  // Whether both branches that cross at a branch point have been traced.
  bool knows_crossing(const BranchPoint& at) const;
  // Whether orbits of twice the period that begin at a doubling have been traced, from there or
  // from their other end.
  bool knows_doubling(const BranchPoint& at) const;
  // Traces the branch through a solution.
  const Branch& trace(const BranchPoint& start, Directions directions);
  // The same both ways from a branch point, which is one of its special points.
  const Branch& trace_across(const BranchPoint& crossing);
  // Its parts that are listed.
  std::vector<OrbitBranch> parts(const Branch& branch) const;

 private:
  // Unit, in (u, parameter/range).
  Vector direction(const SpecialOrbit::Direction& along) const;
  // The solution, written from each impact that its pattern may begin with.
  std::vector<BranchPoint> rewritten(const BranchPoint& solution) const;

  // How many traced branches have a branch point there.
  int crossings(const BranchPoint& at) const;

  OrbitEquations equations_;
  ContinuationOptions options_;
  bool keep_virtual_;
  std::deque<Branch> traced_;  // references to them stay valid
};

}  // namespace graze
