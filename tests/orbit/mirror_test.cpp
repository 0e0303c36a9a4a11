// Between mirrored stops every orbit has its image, u(t) -> -u(t + T/2), among those that are
// found.
#include "graze/orbit/search/detail/mirror.hpp"
#include "graze/assembly/assembly.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/orbit/search/finder.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Phase, stop and speed of every impact, half a period later on the other stop.
bool is_image(const Orbit& orbit, const Orbit& image) {
  if (orbit.impacts.size() != image.impacts.size() || orbit.period != image.period) return false;
  return std::all_of(orbit.impacts.begin(), orbit.impacts.end(), [&](const OrbitImpact& impact) {
    return std::any_of(image.impacts.begin(), image.impacts.end(), [&](const OrbitImpact& other) {
      const double apart =
          std::remainder(impact.phase + std::numbers::pi - other.phase, 2.0 * std::numbers::pi);
      return other.stop == 1 - impact.stop && std::abs(apart) < 1e-9 &&
             std::abs(impact.speed - other.speed) < 1e-9;
    });
  });
}

TEST(Mirror, ImagesAreListedWhateverTheSearchMet) {
  const System system = assemble(support::shipped_scene("07_two_stops"));
  std::size_t orbits = 0;
  for (const unsigned seed : {1u, 2u, 3u}) {
    FinderOptions options;
    options.from_simulation = false;
    options.random_seed = seed;
    const FoundOrbits found = find_orbits(system, {}, options);
    for (const Orbit& orbit : found.orbits)
      EXPECT_TRUE(std::any_of(found.orbits.begin(), found.orbits.end(),
                              [&](const Orbit& other) { return is_image(orbit, other); }))
          << "seed " << seed << ", phase " << orbit.impacts.front().phase;
    orbits += found.orbits.size();
  }
  EXPECT_GE(orbits, 10u);
}

// Two modes between mirrored stops that come to rest on one of them only (found by experiment). The
// image of that motion is one that a run from the mirrored state settles on, half a period later.
TEST(Mirror, OrbitsThatStickHaveTheirImagesToo) {
  System system;
  system.omega = (Vector(2) << 1.0, 5.2).finished();
  system.modal().delta = (Vector(2) << 0.05, 0.03).finished().cwiseProduct(system.omega);
  system.modal().forcing = HarmonicForcing{1.07, 0.0, (Vector(2) << 1.0, 0.3).finished()};
  const Vector row = (Vector(2) << 1.0, -0.9).finished();
  system.stops.push_back({row, 0.85, ImpactLaw{row / row.squaredNorm(), 0.3}});
  system.stops.push_back({-row, 0.85, ImpactLaw{-row / row.squaredNorm(), 0.3}});
  FinderOptions options;
  options.from_closed_form = options.from_random = false;
  std::vector<std::vector<Orbit>> lists;
  for (const double phase : {0.0, std::numbers::pi}) {
    // The same forcing half a period later, from rest as well: the mirrored motion.
    system.modal().forcing->phase = phase;
    const FoundOrbits found = find_orbits(system, support::rest(system), options);
    ASSERT_EQ(found.orbits.size(), 2u) << found.tried;
    const Orbit &a = found.orbits[0], &b = found.orbits[1];
    ASSERT_TRUE(a.sticks() && b.sticks());
    ASSERT_EQ(a.sticking.size(), 1u);
    ASSERT_EQ(b.sticking.size(), 1u);
    EXPECT_EQ(a.sticking[0].stop, 1 - b.sticking[0].stop);
    EXPECT_NEAR(a.sticking[0].duration, b.sticking[0].duration, 1e-9);
    EXPECT_TRUE(is_image(a, b));
    EXPECT_LE(std::max(a.residual, b.residual), 1e-11);
    lists.push_back(found.orbits);
  }
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(same_orbit(lists[0][i], lists[1][i], 1.0)) << i;
}

// One that is its own image is listed once.
TEST(Mirror, OrbitsThatStickOnBothStopsAlikeAreListedOnce) {
  System system = support::forced_oscillator(1.0, 0.05, 0.3, 0.2, 0.5, 1.0);
  Stop below = system.stops[0];
  below.row *= -1.0;
  below.impact().direction *= -1.0;
  system.stops.push_back(below);
  FinderOptions options;
  options.from_closed_form = options.from_random = false;
  const FoundOrbits found = find_orbits(system, support::rest(system), options);
  ASSERT_EQ(found.orbits.size(), 1u) << found.tried;
  EXPECT_EQ(found.orbits[0].sticking.size(), 2u);
}

TEST(Mirror, NeedsStopsThatAreOpposite) {
  const auto stops = [](const std::vector<std::string>& settings) {
    return opposite_stops(assemble(support::shipped_scene("07_two_stops", settings)));
  };
  EXPECT_EQ(stops({}), (std::vector<int>{1, 0}));
  EXPECT_FALSE(stops({"stop.gap=1e-3"}));
  EXPECT_FALSE(stops({"stop.2.restitution=0.7"}));
  EXPECT_FALSE(stops({"gravity.acceleration=9.81"}));
  EXPECT_FALSE(opposite_stops(assemble(support::shipped_scene("05_wagg_one_mode"))));
}

// Between two springs as between two rigid stops.
TEST(Mirror, OrbitsOnSpringsHaveTheirImagesToo) {
  const ContactForce spring{400.0, 1.5, ContactDamping::kPower, 60.0};
  int compared = 0;
  for (const double frequency : {0.8, 1.2, 1.6, 2.0}) {
    SCOPED_TRACE(frequency);
    System system = support::forced_oscillator(1.0, 0.05, 0.0, 1.0, frequency, 1.0);
    system.stops = {{Vector::Constant(1, 1.0), 0.1, spring},
                    {Vector::Constant(1, -1.0), 0.1, spring}};
    const auto opposite = opposite_stops(system);
    ASSERT_TRUE(opposite);
    FinderOptions options;
    options.from_closed_form = options.from_random = false;
    for (const Orbit& orbit :
         find_orbits(system, support::state_of({0.0}, {0.1}), options).orbits) {
      const auto image =
          mirrored_orbit(system, orbit, *opposite, {orbit.section->closure_speed, 10'000, {}});
      ASSERT_TRUE(image);
      EXPECT_TRUE(is_image(orbit, *image));
      ++compared;
    }
    system.stops[1].law = ContactForce{401.0, 1.5, ContactDamping::kPower, 60.0};
    EXPECT_FALSE(opposite_stops(system));
  }
  EXPECT_GE(compared, 2);
}

}  // namespace
}  // namespace graze
