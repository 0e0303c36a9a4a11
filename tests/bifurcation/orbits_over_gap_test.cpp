// Orbits on compliant stops that are joined to the response without contacts: the search finds
// those that a branch over the frequency passes, however far from any other start.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/bifurcation/bounds/orbits_over_gap.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// m = k = 1, c = 0.05, F = 0.02 and a spring of 100 at a gap of 0.1. Its response reaches the stop
// between w = 0.8972718642 and 1.0919721616 (closed form); beyond, up to the fold at 1.5575825936,
// two orbits touch it, and three between the fold at 1.0919720008 and that grazing.
Scene oscillator(double frequency) {
  return parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.025]\n"
      "participation = [1.0]\n[forcing]\namplitude = 0.02\nfrequency = " +
          std::to_string(frequency) +
          "\n[[stop]]\nshape = [1.0]\ngap = 0.1\n"
          "spring = {stiffness = 100.0, exponent = 1.0}\n",
      "oscillator");
}

std::vector<Orbit> found(const Scene& scene, std::uint64_t seed) {
  FinderOptions options;
  options.impacts = 1;
  options.random_seed = seed;
  return search_orbits(assemble(scene), std::nullopt, options).orbits;
}

TEST(OrbitsOverGap, AreAllThatTheResponseLeadsTo) {
  for (const double frequency : {1.0925, 1.1038, 1.55})
    for (const std::uint64_t seed : {1u, 2u}) {
      const std::vector<Orbit> orbits = found(oscillator(frequency), seed);
      ASSERT_EQ(orbits.size(), 2u) << frequency;
      // Either side of a fold.
      EXPECT_NE(orbits[0].stable == true, orbits[1].stable == true) << frequency;
      for (const Orbit& orbit : orbits) EXPECT_LE(orbit.residual, 1e-11);
    }
  EXPECT_EQ(found(oscillator(1.091972), 1).size(), 1u);  // below the fold beside the grazing
  EXPECT_EQ(found(oscillator(0.95), 1).size(), 1u);
  EXPECT_TRUE(found(oscillator(0.897), 1).empty());  // the response is clear
  EXPECT_TRUE(found(oscillator(1.56), 1).empty());
}

// With other numbers: several modes, a force that hardens, damping in the contact.
TEST(OrbitsOverGap, AreFoundOfSeveralModes) {
  const auto scene = [](double gap) {
    return parse_scene(
        "[modal]\nfrequencies = [1.0, 3.3]\ndamping_ratios = [0.02, 0.02]\n"
        "participation = [1.0, 1.0]\n[forcing]\nkind = \"modal\"\namplitude = 1.0\n"
        "frequency = 1.2\n[[stop]]\nshape = [1.0, -0.4]\ngap = " +
            std::to_string(gap) +
            "\nspring = {stiffness = 10.0, exponent = 1.5, "
            "damping = {model = \"hunt-crossley\", alpha = 0.05}}\n",
        "two_modes");
  };
  // The response at the stop is |1/(1 - 1.44 + .048i) - .4/(10.89 - 1.44 + .1584i)| = 2.30 m: one
  // that reaches the stop, and a pair beside the one that does not.
  EXPECT_EQ(found(scene(2.6), 1).size(), 2u);
  EXPECT_EQ(found(scene(2.6), 2).size(), 2u);
}

}  // namespace
}  // namespace graze
