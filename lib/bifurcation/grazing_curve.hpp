// Loci of grazing: the curves in the plane of two parameters along which an orbit touches a stop.
// Its touch is an impact at zero speed, so that they are solutions of the shooting equations with
// one more,
//
//   row.q'_i = 0   at the impact i that touches,
//
// regular where the gap has a simple minimum there. A touch does not change the motion: its
// restitution does not matter.
#pragma once

#include <string>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/touching_orbit.hpp"
#include "graze/continuation/plane_curve.hpp"

namespace graze {

// Remembers the system of the values asked for last: one thread at a time.
class GrazingCurve {
 public:
  // `scale`: as for a branch; `range`: length of the first parameter's (first_range).
  GrazingCurve(const Scene& scene, const std::string& first, const std::string& second,
               ImpactPattern pattern, std::size_t touch, const MotionScale& scale, double range);
  GrazingCurve(const GrazingCurve&) = delete;
  GrazingCurve& operator=(const GrazingCurve&) = delete;

  // In (x, first/range), x the unknowns of the shooting equations; the multipliers are those of the
  // orbit without its touch, none where that has no impact.
  const PlaneCurveProblem& problem() const { return problem_; }
  const ShootingProblem& shooting() const { return shooting_; }
  std::size_t touch() const { return touch_; }
  Vector pack(const std::vector<ImpactPoint>& impacts, double first) const;
  double first_of(const BranchPoint& point) const;
  std::vector<ImpactPoint> impacts_of(const BranchPoint& point) const;
  // Null where the scene does not allow the values; holds until others are asked for.
  const System* system_at(double first, double second) const;

 private:
  std::optional<ZeroEvaluation> evaluate(const Vector& y, double second) const;
  std::vector<Eigenvalue> multipliers(const Vector& y, double second, ErrorBounds errors) const;

  mutable SystemCursor systems_;
  ShootingProblem shooting_;
  std::size_t touch_;
  double range_;
  double speed_unit_;  // m/s
  PlaneCurveProblem problem_;
};

}  // namespace graze
