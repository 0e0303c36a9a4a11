#include "graze/orbit/search/detail/solved_orbit.hpp"

#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Largest number of unknowns of the equations of all impacts at once, which are dense: a step of
// Newton's method takes some 70 ms, and eight times as long with twice as many. Orbits of more
// impacts are followed, which leaves the 2N unknowns of a section.
constexpr int kMostImpactUnknowns = 1000;

bool is_short(const System& system, const ImpactPattern& pattern) {
  return pattern.impacts() * (2 * system.modes() + 1) <= kMostImpactUnknowns;
}

}  // namespace

std::optional<Orbit> minimal_orbit(const System& system, const ShootingProblem& problem,
                                   const ShootingSolution& solution) {
  Orbit orbit = make_orbit(system, problem, solution.x);
  const std::optional<ImpactPattern> shorter = repeated_pattern(orbit);
  if (!shorter) return orbit;
  const ShootingProblem part(*shorter, problem.scale());
  std::vector<ImpactPoint> points = orbit.points();
  points.resize(shorter->stops.size());
  const auto minimal = newton(part, system, part.pack(system, points));
  if (!minimal) return {};
  return make_orbit(system, part, minimal->x);
}

std::optional<Orbit> orbit_near(const System& system, const ImpactPattern& pattern,
                                const std::vector<ImpactPoint>& points) {
  if (!system.has_modal_flights()) return {};
  const ShootingProblem problem(pattern, motion_scale(system));
  const auto solution = newton(problem, system, problem.pack(system, points));
  return solution ? minimal_orbit(system, problem, *solution) : std::nullopt;
}

FollowedAnswer orbit_near(const System& system, const SettledMotion& settled,
                          const SegmentOptions& options) {
  if (!settled.pattern || !is_short(system, *settled.pattern))
    return followed_orbit(system, settled.at_start, settled.period, options);
  FollowedAnswer answer{orbit_near(system, *settled.pattern, settled.points), ""};
  if (!answer.orbit) answer.why_not = "no orbit was confirmed there";
  return answer;
}

std::optional<Orbit> orbit_near(const System& system, const Orbit& neighbour,
                                const SegmentOptions& options) {
  return neighbour.section ? followed_orbit(system, turns_of(neighbour), options).orbit
                           : orbit_near(system, neighbour.pattern(), neighbour.points());
}

}  // namespace graze
