// A connected set of solutions of the shooting equations, judged point by point and divided at its
// grazings into the parts that are orbits of the system.
#pragma once

#include <vector>

#include "graze/bifurcation/orbit_branches.hpp"

namespace graze {

class OrbitComponents {
 public:
  // Refers to all three, which must outlive it.
  OrbitComponents(const SystemFamily& family, const ShootingProblem& shooting,
                  const ContinuationOptions& continuation);

  const ZeroProblem& problem() const { return problem_; }

  // The verdict on a point of a branch, without its multipliers.
  Admissibility admissibility_at(const BranchPoint& point) const;

  // The branches that a traced component consists of: its admissible parts, each ended by the
  // grazing where it stops being an orbit, or with `keep_virtual` the whole in one piece, its
  // grazings among the special points.
  std::vector<OrbitBranch> parts(const Branch& branch, bool keep_virtual) const;

 private:
  OrbitBranchPoint judge(const BranchPoint& point) const;
  SpecialPoint fold(const Fold& fold) const;
  std::optional<SpecialPoint> grazing(const BranchPoint& a, const BranchPoint& b,
                                      const OrbitBranchPoint& at_a,
                                      const OrbitBranchPoint& at_b) const;

  const SystemFamily& family_;
  const ShootingProblem& shooting_;
  const ContinuationOptions& continuation_;
  ZeroProblem problem_;
};

}  // namespace graze
