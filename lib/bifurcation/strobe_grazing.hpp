// Loci of grazing on compliant stops: the curves in the plane of two parameters along which an
// orbit touches a stop at no speed,
//
//   f(x_i) = x_{i+1},   b.q - a = 0,   b.q' = 0   at the forcing angle psi after the start of x_1,
//
// in the unknowns x_1, .., x_p, one parameter and psi, over the other. Regular where the gap has a
// simple minimum there, or a simple maximum: so a contact parts in two. Beside a touch the slope of
// the map has a root's singularity, or jumps where the force does; but what a step of Newton's
// method along a locus meets of it is in proportion to the depth, which the equations hold at zero
// to first order, so that either side serves.
#pragma once

#include <vector>

#include "graze/bifurcation/strobe_plane.hpp"
#include "graze/continuation/plane_curve.hpp"
#include "graze/orbit/strobe_orbit.hpp"

namespace graze {

class StrobeGrazing {
 public:
  // Of orbits of this period that touch this stop. Refers to the plane, which must outlive it.
  StrobeGrazing(StrobePlane& plane, int period, int stop);
  StrobeGrazing(const StrobeGrazing&) = delete;
  StrobeGrazing& operator=(const StrobeGrazing&) = delete;

  // In (x_1, .., x_p, first/range, psi). The orbit has no multipliers here: those of one that
  // touches are those of either side.
  const PlaneCurveProblem& problem() const { return problem_; }
  // The unknown of an orbit that starts with any of its turns.
  Vector pack(const Vector& turns, const StrobeTouch& touch, double first) const;
  // All that are one orbit, as written from each of its turns.
  std::vector<BranchPoint> rewritings(const BranchPoint& point) const;
  double first_of(const BranchPoint& point) const;
  Vector turns_of(const BranchPoint& point) const { return point.u.head(problem_.first); }
  StrobeTouch touch_of(const BranchPoint& point) const;

 private:
  struct Place {
    Eigen::Index turn = 0;
    double angle = 0.0;  // within it
  };
  Place place_of(double psi) const;
  std::optional<ZeroEvaluation> evaluate(const Vector& y, double second) const;
  // b.q'' on the way, in speeds of the forced motion per rad.
  double push(const BranchPoint& point) const;

  StrobePlane& plane_;
  int period_, stop_;
  PlaneCurveProblem problem_;
};

}  // namespace graze
