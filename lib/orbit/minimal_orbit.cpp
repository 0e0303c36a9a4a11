#include "graze/orbit/minimal_orbit.hpp"

#include <vector>

#include "graze/orbit/orbit_identity.hpp"

namespace graze {

std::optional<Orbit> minimal_orbit(const System& system, const ShootingProblem& problem,
                                   const ShootingSolution& solution) {
  Orbit orbit = make_orbit(system, problem, solution.x);
  const std::optional<ImpactPattern> shorter = repeated_pattern(orbit);
  if (!shorter) return orbit;
  const ShootingProblem part(*shorter, problem.scale());
  std::vector<ImpactPoint> points = orbit.points();
  points.resize(shorter->stops.size());
  const auto minimal = newton(part, system, part.pack(points));
  if (!minimal) return {};
  return make_orbit(system, part, minimal->x);
}

}  // namespace graze
