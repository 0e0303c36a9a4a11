// Loci of CH: the curves in the plane of two parameters along which a chatter completes at the very
// instant at which its stop is released, by the distance of chatter_completion.hpp in the unknowns
// u of an orbit at that release and one parameter, over the other.
//
// The slope of that distance is told by differences: Newton's method ends where it is zero.
#pragma once

#include "graze/bifurcation/locus_border.hpp"
#include "graze/bifurcation/orbit_locus.hpp"
#include "graze/bifurcation/passage_equations.hpp"
#include "graze/continuation/plane_curve.hpp"

namespace graze {

class CompletionCurve {
 public:
  // Of orbits at a release of the stop on which the chatter completes. Refers to their equations
  // over two parameters, which must outlive it.
  explicit CompletionCurve(const PassageEquations& equations);
  CompletionCurve(const CompletionCurve&) = delete;
  CompletionCurve& operator=(const CompletionCurve&) = delete;

  // In (u, first/range).
  const PlaneCurveProblem& problem() const { return problem_; }
  // To what its equations can be solved: the distance is told by impacts whose speeds are known to
  // some 1e-5 of their own.
  static constexpr double kTolerance = 1e-9;
  static constexpr int kMostPoints = kMostLocusPoints;
  Vector pack(const Vector& u, double first) const;
  // The orbit there, without multipliers: whether it still sticks is rounding. Nothing where the
  // motion cannot be followed.
  std::optional<Orbit> orbit_at(const BranchPoint& point) const;
  double first_of(const BranchPoint& point) const;
  // How it ends between neighbours where it was halted; at the last where no step led on.
  OrbitLocusEnd end_between(const BranchPoint& a, const BranchPoint& b) const;
  OrbitLocusEnd end_at(const BranchPoint& last) const;

 private:
  std::optional<ZeroEvaluation> evaluate(const Vector& y, double second) const;
  // What happens, as if the chatter completed: on either side it means the same. `minima`: as in
  // PassageOptions.
  std::optional<ReleaseReturn> return_at(const BranchPoint& point, bool minima) const;
  std::optional<Itinerary> itinerary_at(const BranchPoint& point) const;
  const System* system_at(const Vector& y, double second) const;

  const PassageEquations& equations_;
  PlaneCurveProblem problem_;
};

}  // namespace graze
