#include "graze/orbit/search/detail/nearby_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {
namespace {

// A dense solve grows as its cube: 1 ms here, a thousand forcing periods of a small system.
constexpr Eigen::Index kMostDenseUnknowns = 192;

// A motion that repeats to 1e-6 is this near its orbit unless a multiplier is within 1e-3 of one; a
// solution further away is another orbit.
constexpr double kNearMotion = 1e-3;

}  // namespace

std::optional<NearbyOrbit> nearby_orbit(const System& system, const ImpactPattern& pattern,
                                        const std::vector<ImpactPoint>& points) {
  const ShootingProblem problem(pattern, motion_scale(system));
  if (problem.size(system) > kMostDenseUnknowns) return {};
  const auto solution = newton(problem, system, problem.pack(system, points));
  if (!solution) return {};
  NearbyOrbit orbit{pattern, problem.unpack(system, solution->x), {}};
  if (!(distance(system, motion_scale(system), orbit, points) <= kNearMotion)) return {};
  orbit.stable = stability(orbit_multipliers(system, pattern, orbit.points));
  return orbit;
}

double distance(const System& system, const MotionScale& scale, const NearbyOrbit& orbit,
                const std::vector<ImpactPoint>& points) {
  if (points.size() != orbit.points.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImpactPoint &a = orbit.points[i], &b = points[i];
    const Vector& row = system.stops[static_cast<std::size_t>(orbit.pattern.stops[i])].row;
    const double speed = row.dot(a.before.qdot);
    largest = std::max(
        {largest, std::abs(b.theta - a.theta),
         std::abs(row.dot(b.before.qdot) - speed) / std::abs(speed),
         (b.before.q - a.before.q).cwiseAbs().maxCoeff() / scale.displacement,
         ((b.before.qdot - a.before.qdot).cwiseAbs().array() / scale.velocity.array()).maxCoeff()});
  }
  return largest;
}

int shortest_period(const System& system, const NearbyOrbit& orbit, double tolerance) {
  const int p = orbit.pattern.period;
  const std::size_t k = orbit.points.size();
  const auto speed = [&](std::size_t i) {
    return system.stops[static_cast<std::size_t>(orbit.pattern.stops[i])].row.dot(
        orbit.points[i].before.qdot);
  };
  for (int q = 1; q < p; ++q) {
    if (p % q != 0 || k % static_cast<std::size_t>(p / q) != 0) continue;
    const std::size_t n = k / static_cast<std::size_t>(p / q);
    bool repeats = true;
    for (std::size_t i = n; i < k && repeats; ++i)
      repeats =
          orbit.pattern.stops[i] == orbit.pattern.stops[i - n] &&
          std::abs(orbit.points[i].theta - orbit.points[i - n].theta - kTurn * q) <= tolerance &&
          std::abs(speed(i) - speed(i - n)) <= tolerance * std::abs(speed(i));
    if (repeats) return q;
  }
  return p;
}

}  // namespace graze
