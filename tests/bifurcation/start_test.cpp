// Where branches are looked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "branch_checks.hpp"

namespace graze {
namespace {

// Lowest and highest value of each branch whose orbits impact on one stop, in order.
std::vector<std::pair<double, double>> spans(const OrbitBranches& result, int stop) {
  std::vector<std::pair<double, double>> list;
  for (const OrbitBranch& branch : result.branches) {
    if (branch.pattern.stops != std::vector<int>{stop}) continue;
    const auto [low, high] = std::minmax_element(
        branch.points.begin(), branch.points.end(),
        [](const OrbitBranchPoint& a, const OrbitBranchPoint& b) { return a.value < b.value; });
    list.emplace_back(low->value, high->value);
  }
  std::sort(list.begin(), list.end());
  return list;
}

OrbitBranches traced(const Scene& scene) {
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = 1.2;
  options.to = 4.0;
  options.keep_virtual = true;
  options.finder.from_simulation = false;
  return trace_orbits(family, options);
}

// With r(v) a stop has no closed form. Its branches that end within the range, away from the
// scene's own value, are found at other values, whatever closed form the other stop has: they are
// those of the stop alone, for virtual orbits know nothing of other stops.
TEST(Starts, OfAStopWithoutClosedFormAreSoughtBesideOneThatHasIt) {
  Stop below;
  below.shape = {1.0};
  below.side = Side::kBelow;
  below.restitution = {0.9, 0.15};
  for (const double gap : {0.6, 1.0, 2.0}) {
    SCOPED_TRACE(gap);
    Scene scene = support::shipped_scene("04_impact_oscillator", {"forcing.frequency=4"});
    below.gap = gap;
    Scene alone = scene;
    alone.stops = {below};
    scene.stops.push_back(below);
    const auto expected = spans(traced(alone), 0), found = spans(traced(scene), 1);
    EXPECT_EQ(expected.size(), 2u);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].first, expected[i].first, 1e-9);
      EXPECT_NEAR(found[i].second, expected[i].second, 1e-9);
    }
  }
}

}  // namespace
}  // namespace graze
