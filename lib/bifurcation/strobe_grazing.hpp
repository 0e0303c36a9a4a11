// Loci of grazing on compliant stops: the curves in the plane of two parameters along which an
// orbit touches a stop at no speed, by the equations of passage_equations.hpp, in the unknowns x_1,
// .., x_p, one parameter and psi, over the other. Beside a touch the slope of the map has a root's
// singularity, or jumps where the force does; but what a step of Newton's method along a locus
// meets of it is in proportion to the depth, which the equations hold at zero to first order, so
// that either side serves.
#pragma once

#include <vector>

#include "graze/bifurcation/passage_equations.hpp"
#include "graze/continuation/plane_curve.hpp"
#include "graze/orbit/followed_orbit.hpp"

namespace graze {

class StrobeGrazing {
 public:
  // Of orbits that touch this stop. Refers to their equations over two parameters, which must
  // outlive it.
  StrobeGrazing(const PassageEquations& equations, int stop);
  StrobeGrazing(const StrobeGrazing&) = delete;
  StrobeGrazing& operator=(const StrobeGrazing&) = delete;

  // In (x_1, .., x_p, first/range, psi). The orbit has no multipliers here: those of one that
  // touches are those of either side.
  const PlaneCurveProblem& problem() const { return problem_; }
  // The unknown of an orbit that starts with any of its turns.
  Vector pack(const Vector& turns, const Touch& touch, double first) const;
  // All that are one orbit, as written from each of its turns.
  std::vector<BranchPoint> rewritings(const BranchPoint& point) const;
  double first_of(const BranchPoint& point) const;
  Vector turns_of(const BranchPoint& point) const { return point.u.head(problem_.first); }
  // Requires that the scene allows its values.
  Touch touch_of(const BranchPoint& point) const {
    return *equations_.touch_at(point.u, point.parameters(), stop_);
  }

 private:
  const PassageEquations& equations_;
  int stop_;
  PlaneCurveProblem problem_;
};

}  // namespace graze
