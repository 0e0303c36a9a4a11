// The orbits of one impact pattern over two parameters of the scene: the shooting equations as a
// plane problem, for loci of folds, period doublings and tori.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/continuation/plane_problem.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {

// Remembers the system of the values asked for last: one thread at a time.
class OrbitPlane {
 public:
  // `scale`: that of one place for all, as for a branch.
  OrbitPlane(const Scene& scene, const std::string& first, const std::string& second,
             ImpactPattern pattern, const MotionScale& scale);
  OrbitPlane(const OrbitPlane&) = delete;
  OrbitPlane& operator=(const OrbitPlane&) = delete;

  const PlaneProblem& problem() const { return problem_; }
  const ShootingProblem& shooting() const { return shooting_; }
  const ImpactPattern& pattern() const { return shooting_.pattern(); }
  // Null where the scene does not allow the values; holds until others are asked for.
  const System* system_at(double first, double second) const;

 private:
  // Of both parameters, of an allowed system.
  std::array<const System*, 2> tangents_at(double first, double second) const;
  std::optional<PlaneEvaluation> evaluate(const Vector& u, double first, double second) const;
  std::optional<Eigen::MatrixXcd> curvature(const Vector& u, double first, double second,
                                            const std::vector<PlaneProduct>& products) const;

  mutable SystemCursor systems_;
  ShootingProblem shooting_;
  PlaneProblem problem_;
};

}  // namespace graze
