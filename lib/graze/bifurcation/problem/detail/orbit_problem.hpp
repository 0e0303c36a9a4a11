// Periodic orbits of one layout over parameters of the scene, one for a branch and two for a locus:
// their equations as a zero problem, and the orbits of its solutions. Motions between the nodes of
// a layout are prescribed flights (flight_equations.hpp) or segments that are followed
// (segment_equations.hpp).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/problem/orbit_branch.hpp"
#include "graze/continuation/branch.hpp"
#include "graze/orbit/problem/detail/segment_shooting.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// The nodes of its orbits and what lies between: flights from impact to impact, or segments from
// section to section.
using OrbitLayout = std::variant<ImpactPattern, SegmentLayout>;

// Remembers the system of the values asked for last: one thread at a time.
class OrbitProblem {
 public:
  virtual ~OrbitProblem() = default;
  OrbitProblem(const OrbitProblem&) = delete;
  OrbitProblem& operator=(const OrbitProblem&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  virtual OrbitLayout orbit_layout() const = 0;
  virtual int period() const = 0;
  // Not where as many stops are closed as there are modes: all are zero.
  virtual bool has_multipliers() const { return true; }

  // Null where the scene does not allow the values.
  const System* system_at(Parameters at) const { return systems_.at(at); }
  const System* system_at(double value) const { return systems_.at(std::span(&value, 1)); }
  // Its derivative by a parameter; both hold until other values are asked for.
  const System* tangent_at(Parameters at, std::size_t parameter = 0) const {
    return systems_.tangent_at(at, parameter);
  }
  // By every parameter, of an allowed system; empty where one is none.
  std::vector<const System*> tangents_at(Parameters at) const;

  // The orbit of a solution; nothing where its motion is none of this layout, or meets no stop.
  virtual std::optional<OrbitBranchPoint> judge(const SolutionPoint& solution) const = 0;
  // Says of a branch what its orbits have in common: their impacts, or the stops they stick on.
  virtual void name(OrbitBranch& branch) const = 0;
  // Why the branch through a solution is not followed, as a sentence; empty where it is.
  virtual std::string why_not_continued(const SolutionPoint& /*solution*/) const { return {}; }

  // What the second half of a solution differs from the first by: zero where the orbit has half the
  // period. Empty where that is not whole, or cannot be told.
  virtual Vector halves_differ(const SolutionPoint& solution) const = 0;
  // Whether it has half the period.
  bool is_half(const SolutionPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours, and where: the
  // equations are singular there and passed in a step so short that the branch is straight over it.
  bool passes_half(const SolutionPoint& a, const SolutionPoint& b) const;
  SolutionPoint half_between(const SolutionPoint& a, const SolutionPoint& b) const;

  // The same of orbits of twice the period, and a solution seen as one of those, where it is a
  // branch point if it doubles there.
  virtual std::unique_ptr<OrbitProblem> doubled() const = 0;
  virtual SolutionPoint twice_round(const SolutionPoint& solution) const = 0;
  // The same on sections farther from all instants at which the derivative of the motion jumps;
  // null where they are far enough.
  virtual std::unique_ptr<OrbitProblem> clearer(const SolutionPoint& /*solution*/) const {
    return {};
  }
  // The solution, and its tangent, in others that it was made clearer by; nothing where it cannot
  // be solved for there.
  virtual std::optional<SolutionPoint> carried_to(const OrbitProblem& /*other*/,
                                                  const ContinuationOptions& /*options*/,
                                                  const SolutionPoint& solution) const {
    return solution;
  }
  // Every way in which these equations write a solution of others: wherever its period begins, on
  // whatever sections. None where theirs are orbits of another kind.
  virtual std::vector<SolutionPoint> rewritings(const OrbitProblem& of,
                                                const ContinuationOptions& options,
                                                const SolutionPoint& solution) const = 0;

 protected:
  // Refers to the scene.
  OrbitProblem(const Scene& scene, const std::vector<std::string>& parameters);

  // Of the layout, with the derivatives by the parameters that move the system along these
  // tangents. Nothing where a motion cannot be followed.
  virtual std::optional<ShootingLinearisation> linearise(
      const System& system, const Vector& u, std::span<const System* const> tangents) const = 0;
  virtual std::vector<Eigenvalue> multipliers(const System& system, const Vector& u,
                                              ErrorBounds errors) const = 0;
  virtual std::optional<Eigen::MatrixXcd> curvature(
      const Vector& u, Parameters at, const std::vector<CriticalProduct>& products) const = 0;

  mutable SystemCursor systems_;
  ZeroProblem problem_;

 private:
  std::optional<ZeroEvaluation> evaluate(const Vector& u, Parameters at) const;
};

}  // namespace graze
