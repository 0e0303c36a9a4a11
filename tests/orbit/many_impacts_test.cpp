// Orbits of very many impacts, whose equations are too many to be solved all at once.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/detail/solved_orbit.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/system/scale.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Slowly forced and without a loss at the stop, it bounces there until the force has turned: the
// more often, the slower.
System bouncing(int modes, double frequency, double gap) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  system.modal().forcing = HarmonicForcing{frequency, 0.0, Vector(modes)};
  Vector row(modes);
  for (int j = 0; j < modes; ++j) {
    system.omega[j] = 2.0 + 0.6 * j;
    system.modal().delta[j] = (j % 2 == 0 ? 0.3 : 0.05) * system.omega[j];
    system.modal().forcing->amplitude[j] = 8.0 * std::sin(1.3 * j + 0.5) / (1.0 + j);
    row[j] = std::cos(0.9 * j);
  }
  system.stops.push_back({row, gap, ImpactLaw{momentum_direction(row), 1.0}});
  return system;
}

// Followed from section to section, an orbit is the one that the equations of its impacts have.
TEST(ManyImpacts, AFollowedOrbitIsThatOfTheShootingEquations) {
  int orbits = 0;
  for (const int modes : {1, 2, 3})
    for (const double frequency : {0.9, 1.3, 1.7, 2.3, 3.1})
      for (const double gap : {0.1, 0.5}) {
        SCOPED_TRACE(testing::Message() << modes << " modes, " << frequency << ", gap " << gap);
        const System system = bouncing(modes, frequency, gap);
        const SettledMotion settled = settle(system, support::rest(system), {});
        if (!settled.pattern) continue;
        const auto solved = orbit_near(system, *settled.pattern, settled.points);
        const auto followed =
            followed_orbit(system, settled.at_start, settled.period,
                           {default_closure_speed(system, support::rest(system)), 10'000, {}});
        ASSERT_TRUE(solved);
        ASSERT_TRUE(followed.orbit) << followed.why_not;
        ++orbits;
        EXPECT_TRUE(same_orbit(*solved, *followed.orbit, motion_scale(system).speed));
        EXPECT_EQ(solved->stable, followed.orbit->stable);
        ASSERT_EQ(solved->multipliers.size(), followed.orbit->multipliers.size());
        EXPECT_NEAR(std::abs(solved->multipliers[0].value),
                    std::abs(followed.orbit->multipliers[0].value), 1e-7);
      }
  EXPECT_GE(orbits, 10);
}

// Of 32 modes and 408 impacts: 26520 equations, whose matrix would take 5.6 GB and an hour.
TEST(ManyImpacts, OfManyModesAreAnOrbit) {
  const System system = bouncing(32, 0.8, 0.1);
  const auto begin = std::chrono::steady_clock::now();
  const SettledMotion settled = settle(system, support::rest(system), {});
  ASSERT_TRUE(settled.pattern) << settled.classification;
  EXPECT_GT(settled.pattern->impacts(), 200);
  const FollowedAnswer answer = orbit_near(
      system, settled, {default_closure_speed(system, support::rest(system)), 10'000, {}});
  ASSERT_TRUE(answer.orbit) << answer.why_not;
  EXPECT_EQ(static_cast<int>(answer.orbit->impacts.size()), settled.pattern->impacts());
  EXPECT_TRUE(answer.orbit->admissible);
  EXPECT_EQ(answer.orbit->stable, true);
  EXPECT_LT(answer.orbit->residual, 1e-9);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

}  // namespace
}  // namespace graze
