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

// The nodes of its orbits and the motion between them: flights from impact to impact, or segments
// from section to section.
using OrbitLayout = std::variant<ImpactPattern, SegmentLayout>;

// Caches the system of the latest values: for one thread at a time.
class OrbitProblem {
 public:
  virtual ~OrbitProblem() = default;
  OrbitProblem(const OrbitProblem&) = delete;
  OrbitProblem& operator=(const OrbitProblem&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  virtual OrbitLayout orbit_layout() const = 0;
  virtual int period() const = 0;
  // False where as many stops are closed as there are modes: all multipliers are zero.
  virtual bool has_multipliers() const { return true; }

  // Null where the scene does not allow the values.
  const System* system_at(Parameters at) const { return systems_.at(at); }
  const System* system_at(double value) const { return systems_.at(std::span(&value, 1)); }
  // The derivative of the system by a parameter; both are valid until other values are asked for.
  const System* tangent_at(Parameters at, std::size_t parameter = 0) const {
    return systems_.tangent_at(at, parameter);
  }
  // The scene at these values, which must be allowed.
  const Scene& scene_at(Parameters at) const {
    systems_.at(at);
    return systems_.scene();
  }
  // The derivatives by every parameter, for allowed values; empty where one does not exist.
  std::vector<const System*> tangents_at(Parameters at) const;

  // The orbit of a solution; nullopt when its motion does not fit this layout, or meets no stop.
  virtual std::optional<OrbitBranchPoint> judge(const SolutionPoint& solution) const = 0;
  // Sets what the orbits of a branch have in common: their impacts, or the stops they stick on.
  virtual void name(OrbitBranch& branch) const = 0;
  // Why the branch through a solution is not followed, as a sentence; empty where it is.
  virtual std::string why_not_continued(const SolutionPoint& /*solution*/) const { return {}; }

  // Difference between the second half of a solution and the first: zero where the orbit has half
  // the period. Empty where half the period is not whole, or it cannot be computed.
  virtual Vector halves_differ(const SolutionPoint& solution) const = 0;
  // Whether the orbit has half the period.
  bool is_half(const SolutionPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours, and where: the
  // equations are singular there and passed in a step so short that the branch is straight over it.
  bool passes_half(const SolutionPoint& a, const SolutionPoint& b) const;
  SolutionPoint half_between(const SolutionPoint& a, const SolutionPoint& b) const;

  // The same problem for orbits of twice the period, and a solution as one of those, which is a
  // branch point if it doubles there.
  virtual std::unique_ptr<OrbitProblem> doubled() const = 0;
  virtual SolutionPoint twice_round(const SolutionPoint& solution) const = 0;
  // The same problem on sections farther from all instants at which the derivative of the motion
  // jumps; null where they are far enough.
  virtual std::unique_ptr<OrbitProblem> clearer(const SolutionPoint& /*solution*/) const {
    return {};
  }
  // The solution, and its tangent, on the sections of a problem made by clearer(); nullopt when it
  // cannot be solved for there.
  virtual std::optional<SolutionPoint> carried_to(const OrbitProblem& /*other*/,
                                                  const ContinuationOptions& /*options*/,
                                                  const SolutionPoint& solution) const {
    return solution;
  }
  // All forms of a solution of other equations in these: starting wherever its period may begin, on
  // any sections. None where their orbits are of another kind.
  virtual std::vector<SolutionPoint> rewritings(const OrbitProblem& of,
                                                const ContinuationOptions& options,
                                                const SolutionPoint& solution) const = 0;

 protected:
  // Refers to the scene.
  OrbitProblem(const Scene& scene, const std::vector<std::string>& parameters);

  // The equations of the layout, with the derivatives by the parameters that move the system along
  // these tangents. Returns nullopt when a motion cannot be followed.
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
