// The orbits of one impact pattern over parameters of the scene, one for a branch and two for a
// locus: the shooting equations as a zero problem, and the verdict on each of their solutions.
#pragma once

#include <optional>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {

// Remembers the system of the values asked for last: one thread at a time.
class OrbitEquations {
 public:
  // `scale` is that of one place for all: the metric must not change on the way.
  OrbitEquations(const Scene& scene, const std::vector<std::string>& parameters,
                 ImpactPattern pattern, const MotionScale& scale);
  OrbitEquations(const OrbitEquations&) = delete;
  OrbitEquations& operator=(const OrbitEquations&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  const ShootingProblem& shooting() const { return shooting_; }
  const ImpactPattern& pattern() const { return shooting_.pattern(); }

  // Null where the scene does not allow the values.
  const System* system_at(Parameters at) const { return systems_.at(at); }
  // Its derivative by a parameter; both hold until other values are asked for.
  const System* tangent_at(Parameters at, std::size_t parameter = 0) const {
    return systems_.tangent_at(at, parameter);
  }

  // Of a branch: the impacts of a solution; requires its value to be allowed, as do the verdicts.
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
  // By every parameter, of an allowed system.
  std::vector<const System*> tangents_at(Parameters at) const;
  std::optional<ZeroEvaluation> evaluate(const Vector& u, Parameters at) const;
  std::optional<Eigen::MatrixXcd> curvature(const Vector& u, Parameters at,
                                            const std::vector<CriticalProduct>& products) const;

  mutable SystemCursor systems_;
  ShootingProblem shooting_;
  ZeroProblem problem_;
};

}  // namespace graze
