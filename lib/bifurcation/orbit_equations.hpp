// The orbits of one impact pattern over a parameter of the scene: the shooting equations as a zero
// problem, and the verdict on each of their solutions.
#pragma once

#include <optional>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {

// Remembers the system of the value asked for last: one thread at a time.
class OrbitEquations {
 public:
  // `scale` is that of one value for all: the metric of a branch must not change on the way.
  OrbitEquations(const SystemFamily& family, ImpactPattern pattern, const MotionScale& scale);
  OrbitEquations(const OrbitEquations&) = delete;
  OrbitEquations& operator=(const OrbitEquations&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  const ShootingProblem& shooting() const { return shooting_; }
  const ImpactPattern& pattern() const { return shooting_.pattern(); }

  // Null where the scene does not allow the value.
  const System* system_at(double value) const;
  // Its derivative by the parameter; both hold until another value is asked for.
  const System* tangent_at(double value) const;

  // The impacts of a solution; requires its value to be allowed, as do the verdicts.
  std::vector<ImpactPoint> points(const BranchPoint& solution) const;
  // The verdict without multipliers.
  Admissibility admissibility_of(const BranchPoint& solution) const;
  OrbitBranchPoint judge(const BranchPoint& solution) const;

  // What the second half of the impacts differs from the first by, in the units of the unknowns:
  // zero where the orbit has half the period. Empty for patterns that are not twice one.
  Vector halves_differ(const BranchPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours.
  bool passes_half(const BranchPoint& a, const BranchPoint& b) const;

 private:
  std::optional<ZeroEvaluation> evaluate(const Vector& u, double value) const;

  mutable SystemCursor systems_;
  ShootingProblem shooting_;
  ZeroProblem problem_;
};

}  // namespace graze
