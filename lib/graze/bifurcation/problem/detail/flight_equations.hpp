// The orbits of one impact pattern, by prescribed flights from impact to impact: the shooting
// equations as an orbit problem. Beyond the grazings their solutions are virtual.
#pragma once

#include "graze/bifurcation/problem/detail/orbit_problem.hpp"

namespace graze {

class FlightEquations : public OrbitProblem {
 public:
  // `scale` is that of one value of the parameters: the metric must not change along a branch.
  FlightEquations(const Scene& scene, const std::vector<std::string>& parameters,
                  ImpactPattern pattern, const MotionScale& scale);

  const ShootingProblem& shooting() const { return shooting_; }
  const ImpactPattern& pattern() const { return shooting_.pattern(); }
  OrbitLayout orbit_layout() const override { return pattern(); }
  int period() const override { return pattern().period; }

  // For a branch: the impacts of a solution; requires an allowed value of the parameter, as do the
  // classifications.
  std::vector<ImpactPoint> points(const SolutionPoint& solution) const;
  // The classification without multipliers.
  Admissibility admissibility_of(const SolutionPoint& solution) const;
  OrbitBranchPoint orbit_at(const SolutionPoint& solution) const;

  // Returns nullopt when the scene does not allow the value.
  std::optional<OrbitBranchPoint> judge(const SolutionPoint& solution) const override;
  void name(OrbitBranch& branch) const override { branch.pattern = pattern(); }
  Vector halves_differ(const SolutionPoint& solution) const override;
  std::unique_ptr<OrbitProblem> doubled() const override;
  SolutionPoint twice_round(const SolutionPoint& solution) const override;
  std::vector<SolutionPoint> rewritings(const OrbitProblem& of, const ContinuationOptions& options,
                                        const SolutionPoint& solution) const override;

 private:
  std::optional<ShootingLinearisation> linearise(
      const System& system, const Vector& u,
      std::span<const System* const> tangents) const override;
  std::vector<Eigenvalue> multipliers(const System& system, const Vector& u,
                                      ErrorBounds errors) const override;
  std::optional<Eigen::MatrixXcd> curvature(
      const Vector& u, Parameters at, const std::vector<CriticalProduct>& products) const override;

  const Scene& scene_;
  std::vector<std::string> parameters_;
  ShootingProblem shooting_;
};

}  // namespace graze
