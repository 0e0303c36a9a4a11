#include "graze/bifurcation/strobe_equations.hpp"

#include <utility>

#include "graze/bifurcation/half_period.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {

StrobeEquations::StrobeEquations(const SystemFamily& family, const StrobeOptions& options,
                                 int period)
    : systems_(family),
      map_(*family.at(family.value()), options),
      length_(shooting_scale(*family.at(family.value())).length),
      period_(period) {
  problem_ =
      periodic_points([this](const Vector& x, double value) { return evaluate(x, value); }, period);
}

std::optional<MapEvaluation> StrobeEquations::evaluate(const Vector& x, double value) const {
  const System* system = systems_.at(value);
  const System* tangent = systems_.tangent_at(value);
  if (!system || !tangent) return {};
  std::optional<StrobeMap::Image> image = map_.image(*system, x, tangent);
  if (!image) return {};
  return MapEvaluation{std::move(image->image), std::move(image->jacobian),
                       std::move(image->by_parameter)};
}

Vector StrobeEquations::halves_differ(const BranchPoint& solution) const {
  if (period_ % 2 != 0) return {};
  const Eigen::Index half = solution.u.size() / 2;
  return solution.u.tail(half) - solution.u.head(half);
}

bool StrobeEquations::is_half(const BranchPoint& solution) const {
  return period_ % 2 == 0 &&
         halves_differ(solution).norm() <= kShootingAccuracy * (1.0 + solution.u.norm());
}

bool StrobeEquations::passes_half(const BranchPoint& a, const BranchPoint& b) const {
  return turns_round(halves_differ(a), halves_differ(b), kShootingAccuracy * (1.0 + a.u.norm()));
}

std::optional<OrbitBranchPoint> StrobeEquations::judge(const BranchPoint& solution) const {
  return judged_.answer({solution.u, solution.parameter}, [&]() -> std::optional<OrbitBranchPoint> {
    const System* system = systems_.at(solution.parameter);
    if (!system) return {};
    std::vector<Eigenvalue> multipliers = solution.multipliers;
    if (multipliers.empty())
      multipliers = problem_.multipliers(solution.u, solution.parameter, ErrorBounds::kGiven);
    std::optional<Orbit> orbit =
        orbit_of(*system, map_, solution.u, std::move(multipliers), solution.residual);
    if (!orbit) return {};
    return point_of_branch(solution.parameter, std::move(*orbit));
  });
}

}  // namespace graze
