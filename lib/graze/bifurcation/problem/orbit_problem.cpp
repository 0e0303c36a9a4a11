#include "graze/bifurcation/problem/detail/orbit_problem.hpp"

#include <algorithm>
#include <utility>

#include "graze/orbit/problem/detail/polish.hpp"

namespace graze {
namespace {

// Halves nearer than this are the same: solutions are known to about the square root of eps where
// they are least well determined.
double rounding_of(const SolutionPoint& solution) {
  return kShootingAccuracy * (1.0 + solution.u.norm());
}

}  // namespace

OrbitProblem::OrbitProblem(const Scene& scene, const std::vector<std::string>& parameters)
    : systems_(scene, parameters) {
  problem_.evaluate = [this](const Vector& u, Parameters at) { return evaluate(u, at); };
  problem_.multipliers = [this](const Vector& u, Parameters at,
                                ErrorBounds errors) -> std::vector<Eigenvalue> {
    const System* system = system_at(at);
    return system ? multipliers(*system, u, errors) : std::vector<Eigenvalue>();
  };
  problem_.curvature = [this](const Vector& u, Parameters at,
                              const std::vector<CriticalProduct>& products) {
    return curvature(u, at, products);
  };
}

std::vector<const System*> OrbitProblem::tangents_at(Parameters at) const {
  std::vector<const System*> tangents;
  for (std::size_t k = 0; k < at.size(); ++k) {
    tangents.push_back(tangent_at(at, k));
    if (!tangents.back()) return {};
  }
  return tangents;
}

std::optional<ZeroEvaluation> OrbitProblem::evaluate(const Vector& u, Parameters at) const {
  const System* system = system_at(at);
  if (!system) return {};
  const std::vector<const System*> tangents = tangents_at(at);
  if (tangents.size() < at.size()) return {};
  std::optional<ShootingLinearisation> sum = linearise(*system, u, tangents);
  if (!sum) return {};
  return ZeroEvaluation{std::move(sum->residual), std::move(sum->jacobian),
                        std::move(sum->by_parameters), std::move(sum->closing)};
}

bool OrbitProblem::is_half(const SolutionPoint& solution) const {
  const Vector difference = halves_differ(solution);
  return difference.size() > 0 && difference.norm() <= rounding_of(solution);
}

// The difference passes zero there and changes its sign; beyond are the same orbits again, half a
// period later. Differences within rounding do not count.
bool OrbitProblem::passes_half(const SolutionPoint& a, const SolutionPoint& b) const {
  const Vector before = halves_differ(a), now = halves_differ(b);
  return before.size() > 0 && before.size() == now.size() &&
         std::min(before.norm(), now.norm()) > rounding_of(a) && before.dot(now) < 0.0;
}

SolutionPoint OrbitProblem::half_between(const SolutionPoint& a, const SolutionPoint& b) const {
  const double before = halves_differ(a).norm();
  const double part = before / (before + halves_differ(b).norm());
  SolutionPoint at = a;
  at.u += part * (b.u - a.u);
  at.parameter += part * (b.parameter - a.parameter);
  at.multipliers.clear();
  return at;
}

}  // namespace graze
