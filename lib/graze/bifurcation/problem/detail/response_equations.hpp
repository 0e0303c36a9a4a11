// The response that meets no stop (response.hpp) as an orbit problem: its state at forcing phase 0
// is the fixed point of the free flow over a period, which is linear,
//
//   (M - 1) (x - x_0) = 0.
//
// Beyond the grazings its solutions are virtual.
#pragma once

#include "graze/bifurcation/problem/detail/orbit_problem.hpp"
#include "graze/orbit/closed_form/response.hpp"

namespace graze {

class ResponseEquations : public OrbitProblem {
 public:
  // `scale` is that of one value of the parameters.
  ResponseEquations(const Scene& scene, const std::vector<std::string>& parameters,
                    const MotionScale& scale);

  OrbitLayout orbit_layout() const override { return ImpactPattern{}; }
  int period() const override { return 1; }
  // Returns nullopt when the scene does not allow the value, or there is no response.
  std::optional<Response> response(const SolutionPoint& solution) const;
  // The unknowns at a value; nullopt likewise.
  std::optional<Vector> unknowns_at(Parameters at) const;

  std::optional<OrbitBranchPoint> judge(const SolutionPoint& solution) const override;
  void name(OrbitBranch& branch) const override { branch.pattern = {}; }
  Vector halves_differ(const SolutionPoint& /*solution*/) const override { return {}; }
  // Linear motions do not double: returns the same problem.
  std::unique_ptr<OrbitProblem> doubled() const override;
  SolutionPoint twice_round(const SolutionPoint& solution) const override { return solution; }
  std::vector<SolutionPoint> rewritings(const OrbitProblem& of, const ContinuationOptions& options,
                                        const SolutionPoint& solution) const override;

 private:
  Vector packed(const Response& response, double frequency) const;
  std::optional<ShootingLinearisation> linearise(
      const System& system, const Vector& u,
      std::span<const System* const> tangents) const override;
  std::vector<Eigenvalue> multipliers(const System& system, const Vector& u,
                                      ErrorBounds errors) const override;
  std::optional<Eigen::MatrixXcd> curvature(
      const Vector& /*u*/, Parameters /*at*/,
      const std::vector<CriticalProduct>& /*products*/) const override {
    return {};
  }

  const Scene& scene_;
  std::vector<std::string> parameters_;
  MotionScale scale_;
};

}  // namespace graze
