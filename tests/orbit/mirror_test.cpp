// Between mirrored stops every orbit has its image, u(t) -> -u(t + T/2), among those that are
// found.
#include "graze/orbit/mirror.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/orbit/finder.hpp"
#include "support/reference.hpp"

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

}  // namespace
}  // namespace graze
