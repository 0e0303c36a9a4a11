// What a simulation settles on must be among the orbits that the search finds without simulating:
// from a grid of initial states, at several parameter values, compared as sets.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/orbit/search/settled.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using Kind = std::pair<int, int>;  // (p, k)

double speed_scale(const System& system) {
  return motion_scale(system).length * system.forcing()->frequency;
}

// The orbit that a simulation settles on, made minimal; nothing when it settles on none.
std::optional<Orbit> settled_orbit(const System& system, const State& start) {
  SettleOptions options;
  options.periods = 600;
  options.longest_period = 8;
  const SettledMotion settled = settle(system, start, options);
  if (!settled.pattern) return {};
  const ShootingProblem problem(*settled.pattern, motion_scale(system));
  const auto solution = newton(problem, system, problem.pack(system, settled.points));
  if (!solution) return {};
  const Orbit orbit = make_orbit(system, problem, solution->x);
  const auto shorter = repeated_pattern(orbit);
  if (!shorter) return orbit;
  std::vector<ImpactPoint> points = orbit.points();
  points.resize(shorter->stops.size());
  const ShootingProblem part(*shorter, motion_scale(system));
  const auto minimal = newton(part, system, part.pack(system, points));
  if (!minimal) return {};
  return make_orbit(system, part, minimal->x);
}

// The different orbits that motions from a grid of states of the first mode settle on.
std::vector<Orbit> attractors(const System& system) {
  std::vector<Orbit> found;
  for (int i = 0; i < 4; ++i)
    for (int j = -2; j <= 2; ++j) {
      State start = support::rest(system);
      start.q[0] = -0.04 - 0.12 * i;
      start.qdot[0] = 0.5 * j;
      bool clear = true;
      for (const Stop& stop : system.stops) clear = clear && stop.row.dot(start.q) < stop.gap;
      if (!clear) continue;
      const std::optional<Orbit> orbit = settled_orbit(system, start);
      if (!orbit) continue;
      bool known = false;
      for (const Orbit& other : found)
        known = known || same_orbit(other, *orbit, speed_scale(system));
      if (!known) found.push_back(*orbit);
    }
  return found;
}

// Every attractor of up to six impacts is listed by the search for its kind; adds the kinds seen.
void expect_listed(const System& system, std::set<Kind>& kinds) {
  std::map<Kind, FoundOrbits> lists;
  for (const Orbit& orbit : attractors(system)) {
    const Kind kind{orbit.period, static_cast<int>(orbit.impacts.size())};
    if (kind.second > 6) continue;
    kinds.insert(kind);
    if (!lists.contains(kind)) {
      FinderOptions options;
      options.period = kind.first;
      options.impacts = kind.second;
      options.from_closed_form = options.from_simulation = false;
      lists[kind] = find_orbits(system, {}, options);
    }
    bool listed = false;
    for (const Orbit& other : lists[kind].orbits)
      listed = listed || same_orbit(other, orbit, speed_scale(system));
    EXPECT_TRUE(listed) << "a stable (" << kind.first << ", " << kind.second
                        << ") orbit is missing; first phase " << orbit.impacts[0].phase;
  }
}

// x'' + .1 x' + x = cos(W t), stop at .1, r = .6.
TEST(Attractors, OfAnOscillatorAreListed) {
  std::set<Kind> kinds;
  for (int i = 0; i < 24; ++i) {
    const double frequency = 0.7 + 0.15 * i;
    SCOPED_TRACE(testing::Message() << "frequency " << frequency);
    expect_listed(support::forced_oscillator(1.0, 0.05, 0.1, 0.6, frequency, 1.0), kinds);
  }
  for (const Kind& kind : {Kind{1, 1}, Kind{2, 1}, Kind{1, 2}, Kind{2, 2}})
    EXPECT_TRUE(kinds.contains(kind)) << kind.first << ", " << kind.second;
}

// The same between two stops that differ.
TEST(Attractors, BetweenTwoStopsAreListed) {
  std::set<Kind> kinds;
  for (int i = 0; i < 12; ++i) {
    const double frequency = 0.8 + 0.25 * i;
    SCOPED_TRACE(testing::Message() << "frequency " << frequency);
    System system = support::forced_oscillator(1.0, 0.05, 0.3, 0.6, frequency, 1.0);
    system.stops.push_back({-Vector::Ones(1), 0.5, ImpactLaw{-Vector::Ones(1), 0.7}});
    expect_listed(system, kinds);
  }
  EXPECT_TRUE(kinds.contains(Kind(1, 2)));
}

// A second mode that rings, and r that falls with the speed.
TEST(Attractors, OfTwoModesWithRestitutionBySpeedAreListed) {
  std::set<Kind> kinds;
  for (const double frequency : {0.9, 1.15, 1.5, 2.7, 3.3}) {
    SCOPED_TRACE(testing::Message() << "frequency " << frequency);
    System system{
        (Vector(2) << 1.0, 4.3).finished(), NaturalModes{(Vector(2) << 0.05, 0.1).finished()}, {}};
    const Vector row = (Vector(2) << 1.0, -0.6).finished();
    system.stops.push_back(
        {row, 0.1, ImpactLaw{row / row.squaredNorm(), Restitution(std::vector<double>{0.8, 0.1})}});
    expect_listed(support::forced(system, frequency, 0.0, (Vector(2) << 1.0, 0.3).finished()),
                  kinds);
  }
  for (const Kind& kind : {Kind{1, 2}, Kind{2, 4}, Kind{2, 1}})
    EXPECT_TRUE(kinds.contains(kind)) << kind.first << ", " << kind.second;
}

}  // namespace
}  // namespace graze
