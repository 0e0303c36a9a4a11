// Multipliers of orbits on compliant stops over several forcing periods.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// u'' + .04 u' + (1 + 3 [u > 0]) u: half periods pi and pi / 2, forced at twice the frequency 4/3
// of its free motion, so that it answers at half the forcing's. The second mode follows, with so
// much damping that it forgets nine digits within a forcing period.
System answering_at_half_the_frequency() {
  System system;
  system.omega = Vector{{1.0, 12.0}};
  system.modal().delta = Vector{{0.02, 9.0}};
  system.modal().forcing = HarmonicForcing{8.0 / 3.0, 0.0, Vector{{1.0, 0.3}}};
  const Vector row{{1.0, 0.2}};
  system.stops.push_back({row, 0.0, ContactForce{3.0, 1.0, ContactDamping::kNone, 0.0}});
  return system;
}

// A spring without damping takes nothing from the volume in the state space: by Liouville the
// product of all multipliers of p periods T is exp(-2 p T sum delta), here 1.2e-37. The two of the
// second mode have 3.8e-19 each, below the rounding of the formed product, 2e-16. From the factors,
// each with 6.2e-10 beside 1, either is known to about eps / 6.2e-10 = 3.6e-7, the product of both
// to 7e-7.
TEST(SegmentMultipliers, SmallOnesOfTwoPeriodsAreKnownToTheRoundingOfOne) {
  const System system = answering_at_half_the_frequency();
  const SectionMap map(system, {}, {});
  State state = support::state_of({0.1, 0.0}, {0.3, 0.0});
  for (int turn = 0; turn < 600; ++turn) {
    const std::optional<TrajectorySegment> segment =
        map.follow(system, map.pack(system, state), 0.0, 1);
    ASSERT_TRUE(segment);
    state = {segment->end.q, segment->end.qdot};
  }
  const FollowedAnswer answer = followed_orbit(system, state, 2, {});
  ASSERT_TRUE(answer.orbit) << answer.why_not;
  ASSERT_EQ(answer.orbit->period, 2);
  ASSERT_EQ(answer.orbit->multipliers.size(), 4u);
  Complex product = 1.0;
  for (const Eigenvalue& multiplier : answer.orbit->multipliers) product *= multiplier.value;
  const double exact = std::exp(-4.0 * system.period() * system.delta().sum());
  EXPECT_NEAR(product.real() / exact, 1.0, 1e-6);
  EXPECT_EQ(answer.orbit->stable, true);
}

}  // namespace
}  // namespace graze
