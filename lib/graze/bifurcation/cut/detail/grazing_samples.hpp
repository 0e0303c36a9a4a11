// Points within the steps of a branch of orbits, as many as needed for its classification to change
// at most once between neighbours.
//
// A step may lead from orbit to orbit across virtual solutions, when a gap or an impact speed falls
// below zero and recovers; or across orbits between two virtual solutions, when one quantity
// recovers before another is lost. The quantities that must stay positive are known with their
// rates at both ends (orbit_margins.hpp), and the cubic through them shows where to search
// (margin_interpolant.hpp). The classification there is decided by the solution itself.
//
// Cheap tests come first: gaps are examined only where the smallest of them is nearer to zero than
// its possible change within the step.
#pragma once

#include <list>
#include <optional>
#include <vector>

#include "graze/bifurcation/problem/detail/flight_equations.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/special/detail/margin_interpolant.hpp"
#include "graze/orbit/problem/detail/orbit_margins.hpp"

namespace graze {

// A solution with the quantities that decide its classification, and their rates.
struct SeenSolution {
  const SolutionPoint* point = nullptr;
  bool admissible = false;
  std::optional<double> clearance;  // m
  std::vector<OrbitMargin> speeds;
  double drift = 0.0;  // of gaps, m per unit of arclength

  double smallest_speed() const;  // m/s
};

// A solution that was computed between two points of the branch.
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
  // The samples between neighbours a and b, in order; empty where a and b's classifications show
  // all.
  std::list<GrazingSample> between(const SeenSolution& a, const SeenSolution& b);

 private:
  // The direction of the branch at a point.
  OrbitDirection direction(const SolutionPoint& point) const;
  std::vector<OrbitMargin> approaches(const SeenSolution& solution, double level) const;
  std::vector<MarginInterpolant> interpolants(const SeenSolution& a, const SeenSolution& b) const;
  void add_approaches(const SeenSolution& a, const SeenSolution& b, double step, double level,
                      std::vector<MarginInterpolant>& interpolants) const;
  // The next sample between a and b; nullopt when no change is suspected.
  std::optional<SolutionPoint> suspected(const SeenSolution& a, const SeenSolution& b);

  const FlightEquations& equations_;
  Corrector corrector_;
};

}  // namespace graze
