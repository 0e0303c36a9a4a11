// Points within the steps of a branch of orbits, so many that between neighbouring ones its
// classification changes once at most.
//
// A step may lead from orbit to orbit across solutions that are none: a gap or an impact speed dips
// below zero and recovers; or across orbits between two solutions that are none, where one of them
// recovers before another is lost. What must stay positive is known with its rate at both ends
// (orbit_margins.hpp), and the cubic through them tells where to look (margin_interpolant.hpp).
// What is found there is decided by the solution itself.
//
// Cheap tests first: gaps are looked at only where the smallest of them is nearer to zero than it
// may come within the step.
#pragma once

#include <list>
#include <optional>
#include <vector>

#include "graze/bifurcation/problem/detail/flight_equations.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/special/detail/margin_interpolant.hpp"
#include "graze/orbit/problem/detail/orbit_margins.hpp"

namespace graze {

// A solution with what its classification rests on, and how fast that changes.
struct SeenSolution {
  const SolutionPoint* point = nullptr;
  bool admissible = false;
  std::optional<double> clearance;  // m
  std::vector<OrbitMargin> speeds;
  double drift = 0.0;  // of gaps, m per unit of arclength

  double smallest_speed() const;  // m/s
};

// One that was looked at between two points of the branch.
struct GrazingSample {
  SolutionPoint point;
  OrbitBranchPoint at;
  SeenSolution seen;
};

class GrazingSamples {
 public:
  // Refers to both, which must outlive it.
  GrazingSamples(const FlightEquations& equations, const ContinuationOptions& options);

  // Refers to the point.
  SeenSolution seen(const SolutionPoint& point, const OrbitBranchPoint& at) const;
  // Those between neighbours a and b, in order. Nothing where all goes as their classifications
  // say.
  std::list<GrazingSample> between(const SeenSolution& a, const SeenSolution& b);

 private:
  // In which the branch runs there.
  OrbitDirection direction(const SolutionPoint& point) const;
  std::vector<OrbitMargin> approaches(const SeenSolution& solution, double level) const;
  std::vector<MarginInterpolant> interpolants(const SeenSolution& a, const SeenSolution& b) const;
  void add_approaches(const SeenSolution& a, const SeenSolution& b, double step, double level,
                      std::vector<MarginInterpolant>& interpolants) const;
  // The solution between a and b to be looked at next; nothing where none is in doubt.
  std::optional<SolutionPoint> suspected(const SeenSolution& a, const SeenSolution& b);

  const FlightEquations& equations_;
  Corrector corrector_;
};

}  // namespace graze
