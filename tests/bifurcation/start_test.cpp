// Where branches are looked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "branch_checks.hpp"
#include "graze/orbit/search/settled.hpp"

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
  SceneStop below;
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

// x'' + x = cos(W t), gap .2, nothing damped and r = 1: one impact in two periods at a crest of the
// forcing, phase 0 or pi, at speed -(gap - X) tan(2 pi/W), X = +-1/(1 - W^2)
// (tests/orbit/closed_form_test.cpp). At pi it vanishes where gap = X, W^2 = 6.
TEST(Starts, AreFoundWithoutDampingAndLossAtImpacts) {
  Scene scene = support::shipped_scene(
      "04_impact_oscillator",
      {"stop.gap=0.2", "stop.restitution=1", "modal.damping_ratios=[0.0]", "initial.q=[0.0]"});
  const OrbitBranches result = support::trace(scene, "forcing.frequency", 2.1, 3.9, false, 2);
  ASSERT_EQ(result.branches.size(), 2u);
  const double gap = 0.2;
  for (const OrbitBranch& branch : result.branches) {
    EXPECT_NEAR(std::max(branch.points.front().value, branch.points.back().value), 3.9, 1e-12);
    for (const OrbitBranchPoint& point : branch.points) {
      const OrbitImpact& impact = point.orbit.impacts.front();
      EXPECT_NEAR(std::sin(impact.phase), 0.0, 1e-10);
      const double crest = std::cos(impact.phase) / (1.0 - point.value * point.value);
      EXPECT_NEAR(impact.speed, -(gap - crest) * std::tan(2.0 * std::numbers::pi / point.value),
                  1e-10 * (1.0 + impact.speed));
    }
  }
  const auto grazings = support::special_points(result, SpecialKind::kGrazing);
  ASSERT_EQ(grazings.size(), 2u);
  EXPECT_NEAR(grazings[1]->at.value, std::sqrt(6.0), 1e-9);
  // The other touches in between: x = X cos(W t) + A cos(t - P/2) reaches the gap and not more.
  const double w = grazings[0]->at.value, duration = 4.0 * std::numbers::pi / w;
  const double size = 1.0 / (1.0 - w * w), free = (gap - size) / std::cos(0.5 * duration);
  double highest = -1.0;
  // Away from the impacts; the highest of the samples misses by half the square of their distance.
  constexpr int kSamples = 1000000;
  for (int i = kSamples / 10; i < kSamples - kSamples / 10; ++i) {
    const double t = duration * i / kSamples;
    highest = std::max(highest, size * std::cos(w * t) + free * std::cos(t - 0.5 * duration));
  }
  EXPECT_NEAR(highest, gap, 1e-9);
}

// On such a branch both multipliers sit on the circle or are reciprocal; with the acceleration a at
// the impact their sum is -2 cos P + 2 a/v sin P. It passes -2 once over the first branch above,
// and that is all that happens there.
TEST(Starts, OfConservativeOrbitsLeadToNoTorus) {
  Scene scene = support::shipped_scene(
      "04_impact_oscillator",
      {"stop.gap=0.2", "stop.restitution=1", "modal.damping_ratios=[0.0]", "initial.q=[0.0]"});
  const OrbitBranches result = support::trace(scene, "forcing.frequency", 2.1, 3.9, false, 2);
  EXPECT_TRUE(support::special_points(result, SpecialKind::kTorus).empty());
  const auto doublings = support::special_points(result, SpecialKind::kPeriodDoubling);
  ASSERT_EQ(doublings.size(), 1u);
  const double w = doublings[0]->at.value, duration = 4.0 * std::numbers::pi / w;
  const double speed = -(0.2 - 1.0 / (1.0 - w * w)) * std::tan(0.5 * duration);
  EXPECT_NEAR(-2.0 * std::cos(duration) + 2.0 * (1.0 - 0.2) / speed * std::sin(duration), -2.0,
              1e-8);
}

// Motions that settled on doubled orbits of the one-mode beam, wherever: their branch ends at the
// doubling of the (1, 1) orbits, which have a branch of their own, and is not traced back along the
// same orbits half a period later, wherever the steps fall.
TEST(Starts, DoubledOrbitsThatMotionsSettleOnEndAtTheirDoubling) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode", {"stop.gap=1.05e-3"});
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = 15.0;
  options.to = 120.0;
  options.response = false;
  const OrbitBranches once = trace_orbits(family, options);
  std::vector<double> doublings;
  for (const auto& point : support::special_points(once, SpecialKind::kPeriodDoubling))
    doublings.push_back(point->at.value);
  options.impacts = 0;
  for (const double value : {59.62, 59.68, 59.7, 59.75, 59.8, 59.82}) {
    SCOPED_TRACE(value);
    const System system = *family.at(value);
    SettledMotion settled =
        settle(system, State{Vector::Zero(system.modes()), Vector::Zero(system.modes())});
    ASSERT_EQ(settled.period, 2);
    options.settled = {{value, settled.at_start}};
    const OrbitBranches result = trace_orbits(family, options);
    ASSERT_EQ(result.branches.size(), 1u);
    const OrbitBranch& doubled = result.branches.front();
    EXPECT_EQ(doubled.pattern.period, 2);
    const bool first = doubled.ends[0] == OrbitBranchEnd::kPeriodDoubling;
    ASSERT_TRUE(first || doubled.ends[1] == OrbitBranchEnd::kPeriodDoubling);
    const double end = (first ? doubled.points.front() : doubled.points.back()).value;
    double nearest = 1.0;
    for (const double doubling : doublings) nearest = std::min(nearest, std::abs(doubling - end));
    EXPECT_LE(nearest, 1e-9 * end);
  }
}

}  // namespace
}  // namespace graze
