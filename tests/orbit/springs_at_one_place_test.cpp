// Two springs on either side of one place make a spring without a gap: what leaves the one enters
// the other at the same instant.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>

#include "graze/assembly/assembly.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// u'' + 0.05 u' + u + k u^n = 0.1 cos(w t), the spring made of two stops at u = 0.
Scene between_springs(double frequency, double stiffness, double exponent) {
  std::string text =
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.025]\n"
      "participation = [1.0]\n[forcing]\namplitude = 0.1\nfrequency = " +
      std::to_string(frequency) + "\n";
  for (const char* side : {"above", "below"})
    text += std::string("[[stop]]\nshape = [1.0]\ngap = 0.0\nside = \"") + side +
            "\"\nspring = {stiffness = " + std::to_string(stiffness) +
            ", exponent = " + std::to_string(exponent) + "}\n";
  return parse_scene(text, "between_springs");
}

FoundOrbits found(const Scene& scene, std::uint64_t seed) {
  FinderOptions options;
  options.impacts = 2;
  options.random_seed = seed;
  // Against hanging; the search takes some tenths of a second.
  options.stop.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  FoundOrbits orbits = find_orbits(assemble(scene), std::nullopt, options);
  EXPECT_FALSE(options.stop.requested()) << "hangs";
  return orbits;
}

// With n = 1 it is a linear oscillator: one orbit, which passes u = 0 twice a period at the speed
// A w, and multipliers of the modulus exp(-c T/2).
TEST(SpringsAtOnePlace, AreALinearSpring) {
  const double w = 1.5, k = 0.75;
  const double speed = 0.1 * w / std::hypot(1.0 + k - w * w, 0.05 * w);
  for (const std::uint64_t seed : {1u, 2u}) {
    const FoundOrbits orbits = found(between_springs(w, k, 1.0), seed);
    ASSERT_EQ(orbits.orbits.size(), 1u);
    const Orbit& orbit = orbits.orbits.front();
    ASSERT_EQ(orbit.impacts.size(), 2u);
    for (const OrbitImpact& impact : orbit.impacts) EXPECT_NEAR(impact.speed, speed, 1e-11);
    EXPECT_NEAR(orbit.impacts[1].phase - orbit.impacts[0].phase, 0.5 * kTurn, 1e-11);
    for (const Eigenvalue& multiplier : orbit.multipliers)
      EXPECT_NEAR(std::abs(multiplier.value), std::exp(-0.025 * kTurn / w), 1e-10);
  }
}

// Duffing's equation, and one with Hertzian springs: every start ends, and leads to an orbit that
// is symmetric, as their response is.
TEST(SpringsAtOnePlace, EndEverySearch) {
  for (const double exponent : {3.0, 1.5})
    for (const std::uint64_t seed : {1u, 2u}) {
      const FoundOrbits orbits = found(between_springs(1.0, 0.5, exponent), seed);
      ASSERT_FALSE(orbits.orbits.empty());
      const Orbit& orbit = orbits.orbits.front();
      EXPECT_NEAR(orbit.impacts[0].speed, orbit.impacts[1].speed, 1e-10);
    }
}

}  // namespace
}  // namespace graze
