// Loci of grazing on compliant stops: the curves in the plane of two parameters along which an
// orbit touches a stop at no speed, by the equations of passage_equations.hpp, in the unknowns x_1,
// .., x_p, one parameter and psi, over the other. Beside a touch the slope of the map has a root's
// singularity, or jumps where the force does; but what a step of Newton's method along a locus
// meets of it is in proportion to the depth, which the equations hold at zero to first order, so
// that either side serves.
#pragma once

#include <vector>

#include "graze/bifurcation/orbit_locus.hpp"
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
  static constexpr double kTolerance = 1e-11;  // as of a locus
  static constexpr int kMostPoints = kMostBranchPoints;
  // The unknown of an orbit that starts with any of its turns.
  Vector pack(const Vector& turns, const Touch& touch, double first) const;
  // All that are one orbit, as written from each of its turns.
  std::vector<BranchPoint> rewritings(const BranchPoint& point) const;
  double first_of(const BranchPoint& point) const;
  // Where it was halted: a touch from outside and one from within a contact are two things.
  OrbitLocusEnd end_between(const BranchPoint&, const BranchPoint&) const {
    return OrbitLocusEnd::kGrazing;
  }
  OrbitLocusEnd end_at(const BranchPoint&) const { return OrbitLocusEnd::kNotConverged; }
  // With its touch, without multipliers; nothing where the motion cannot be followed.
  std::optional<Orbit> orbit_at(const BranchPoint& point) const;

 private:
  const PassageEquations& equations_;
  int stop_;
  PlaneCurveProblem problem_;
};

}  // namespace graze
