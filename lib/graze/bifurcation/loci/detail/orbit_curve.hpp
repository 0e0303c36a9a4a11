// Loci of orbits by a condition besides the equations of the orbits: a grazing contact at zero
// speed (flight_grazing.hpp, segment_grazing.hpp), a chatter that just completes
// (completion_curve.hpp). Their unknown is (u, first/range, ..), over the second parameter.
#pragma once

#include <memory>
#include <vector>

#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/bifurcation/problem/detail/orbit_problem.hpp"
#include "graze/continuation/locus/detail/plane_curve.hpp"

namespace graze {

class OrbitCurve {
 public:
  virtual ~OrbitCurve() = default;
  OrbitCurve(const OrbitCurve&) = delete;
  OrbitCurve& operator=(const OrbitCurve&) = delete;

  // Gives the multipliers of its orbits, where they have any.
  const PlaneCurveProblem& problem() const { return problem_; }
  const LocusOrbits& orbits() const { return *orbits_; }
  LocusSite site_of(const SolutionPoint& point) const;
  // All cyclic relabellings of the solution: the same orbit from each place where it may begin.
  virtual std::vector<SolutionPoint> rewritings(const SolutionPoint& point) const {
    return {point};
  }

 protected:
  // Refers to the equations over two parameters; u has n entries, the curve's unknown `further`
  // ones besides. `unit`: of the first parameter.
  OrbitCurve(const OrbitProblem& equations, Eigen::Index n, Eigen::Index further, double unit,
             std::unique_ptr<LocusOrbits> orbits);

  std::array<double, 2> parameters_of(const Vector& y, double second) const {
    return {y[problem_.first] * unit_, second};
  }
  // The equations of the orbits with one more, that a value vanishes; with its slope by (u,
  // first/range) and second. Returns nullopt when they cannot be evaluated.
  struct Condition {
    double value = 0.0;
    Vector slope;
    double by_second = 0.0;
  };
  std::optional<ZeroEvaluation> with(const Vector& y, double second,
                                     const std::optional<Condition>& condition) const;

  const OrbitProblem& equations_;
  double unit_;
  PlaneCurveProblem problem_;

 private:
  std::unique_ptr<LocusOrbits> orbits_;
};

}  // namespace graze
