// Branches on compliant stops whose contacts pass the stroboscopic section.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr double kCoefficient = 3.794962790783486;

// Two modes between two stops with Kelvin-Voigt damping. On one branch a contact begins at the
// forcing phase 0 at w = 2.60027292308, where nothing happens to its orbits.
Scene between_stops() {
  std::string text = R"(
[modal]
frequencies = [1.0, 3.54346503537961]
damping_ratios = [0.0656183635401234, 0.09605963396269726]
participation = [1.0, 1.0]
[forcing]
kind = "modal"
amplitude = 1.0
frequency = 2.2943301996135768
)";
  for (const char* stop : {"gap = 0.18462425629103513\nside = \"above\"",
                           "gap = 0.21391668866603358\nside = \"below\""})
    text += std::string("[[stop]]\nshape = [1.0, 0.5521008854238876]\n") + stop + R"(
[stop.spring]
stiffness = 1111.5945527702863
exponent = 1.0
damping = {model = "kelvin-voigt", coefficient = 3.794962790783486}
)";
  return parse_scene(text, "between_stops");
}

// On one mode and one stop, where the first contact's phase falls through 0 as the gap shrinks.
Scene oscillator(double gap) {
  return parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.05]\n"
      "participation = [1.0]\n[forcing]\namplitude = 1.0\nfrequency = 2.0\n"
      "[[stop]]\nshape = [1.0]\ngap = " +
          std::to_string(gap) +
          "\nspring = {stiffness = 50.0, exponent = 1.0, "
          "damping = {model = \"kelvin-voigt\", coefficient = 1.5}}\n",
      "oscillator");
}

OrbitBranches traced(const Scene& scene, const std::string& parameter, double from, double to,
                     int impacts, double step = 0.0) {
  const SystemFamily family(scene, parameter);
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.impacts = impacts;
  options.max_step = step;
  options.start_values = 3;
  options.finder.from_random = false;
  return trace_orbits(family, options);
}

// Multipliers multiply to what the damping leaves of a volume, by the structure's own decay and
// the stop's while it is loaded: whatever section the orbit was solved at.
void expect_volumes_to_shrink(const SystemFamily& family, const OrbitBranches& result,
                              double coefficient, double mobility) {
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranchPoint& point : branch.points) {
      const System system = *family.at(point.value);
      double loaded = 0.0;
      for (const OrbitImpact& impact : point.orbit.impacts) loaded += impact.contact->duration;
      const double shrinks = 2.0 * system.delta().sum() * system.period() * point.orbit.period +
                             coefficient * mobility * loaded;
      double product = 1.0;
      for (const Eigenvalue& multiplier : point.orbit.multipliers)
        product *= std::abs(multiplier.value);
      EXPECT_NEAR(product, std::exp(-shrinks), 1e-8) << point.value;
    }
}

TEST(CompliantSections, PassContactsAtTheSection) {
  const Scene scene = between_stops();
  const SystemFamily family(scene, "forcing.frequency");
  for (const double to : {2.65, 2.62}) {
    const OrbitBranches result = traced(scene, "forcing.frequency", 2.55, to, 2);
    EXPECT_EQ(result.cut_short, 0);
    ASSERT_FALSE(result.branches.empty());
    for (const OrbitBranch& branch : result.branches)
      for (const OrbitBranchEnd end : branch.ends)
        EXPECT_EQ(end, OrbitBranchEnd::kParameterLimit) << branch.id;
    expect_volumes_to_shrink(family, result, kCoefficient, 1.0 + std::pow(0.5521008854238876, 2));
    // Stated at the forcing phase 0, wherever it was solved.
    for (const OrbitBranch& branch : result.branches)
      for (const OrbitBranchPoint& point : branch.points)
        EXPECT_NEAR(std::remainder(point.orbit.section->at.phase, 2.0 * std::acos(-1.0)), 0.0,
                    1e-12);
  }
}

TEST(CompliantSections, AreOneBranchInOrder) {
  const Scene scene = oscillator(0.1);
  const OrbitBranches result = traced(scene, "forcing.frequency", 1.3, 2.6, 1);
  const SystemFamily family(scene, "forcing.frequency");
  expect_volumes_to_shrink(family, result, 1.5, 1.0);
  EXPECT_EQ(result.cut_short, 0);
  int passed = 0;
  for (const OrbitBranch& branch : result.branches)
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const OrbitBranchPoint &a = branch.points[i - 1], &b = branch.points[i];
      EXPECT_NE(a.value, b.value);  // no orbit twice
      const double phase = std::remainder(
          b.orbit.impacts.front().phase - a.orbit.impacts.front().phase, 2.0 * std::acos(-1.0));
      EXPECT_LT(std::abs(phase), 0.5);
      passed += std::abs(b.orbit.impacts.front().phase - a.orbit.impacts.front().phase) > 3.0;
    }
  EXPECT_GE(passed, 1);
}

}  // namespace
}  // namespace graze
