// Branches of orbits that stick keep to one family of solutions: beside a grazing, where an orbit
// with an impact and one without lie within the residual of each other, and where a step leads from
// one branch to another with the same events.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "branch_checks.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Of the branches on either side of the grazing one loses its second impact there and the other an
// approach: each is located from its own side. On the former every orbit has two impacts.
TEST(StickingFamily, ABranchThatGrazesKeepsItsImpact) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 3.7]\ndamping_ratios = [0.03, 0.03]\n"
      "participation = [1.0, 0.4]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.8\n"
      "[[stop]]\nshape = [1.0, -0.8]\ngap = 0.4\nrestitution = 0.0\n",
      "two_modes.toml");
  for (const double step : {0.03, 0.01, 0.003}) {
    SCOPED_TRACE(step);
    const OrbitBranches result =
        support::trace_from_runs(scene, "stop.gap", {.from = 0.2, .to = 0.26, .max_step = step});
    std::vector<double> by_speed, by_approach;
    for (const SpecialPoint* special : support::special_points(result, SpecialKind::kGrazing))
      (special->by_speed ? by_speed : by_approach).push_back(special->at.value);
    ASSERT_EQ(by_speed.size(), 1u);
    ASSERT_EQ(by_approach.size(), 1u);
    // Five solutions from 1e-5 away on miss it by 1e-5 of that (sticking_grazing.cpp).
    EXPECT_NEAR(by_speed[0] / by_approach[0], 1.0, 3e-10);
    for (const OrbitBranch& branch : result.branches) {
      const bool impacts_twice =
          std::any_of(branch.special.begin(), branch.special.end(),
                      [](const SpecialPoint& special) { return special.by_speed; });
      for (const OrbitBranchPoint& point : branch.points) {
        // On the grazing itself an approach may touch or not.
        if (std::abs(point.value / by_approach[0] - 1.0) < 1e-10) continue;
        EXPECT_EQ(point.orbit.impacts.size(), impacts_twice ? 2u : 1u) << point.value;
        if (impacts_twice && point.smallest_speed < 1e-2) {
          EXPECT_NE(point.orbit.stable, true) << "its map stretches like 1/v: " << point.value;
        }
      }
    }
  }
}

// Three modes whose chatter completes here and there: between 0.23138 and 0.23365 lie other
// branches, at 0.2334 all orbits of one period are unstable, and the motion settles on two periods.
TEST(StickingFamily, AStepDoesNotLeadToAnotherBranchWithTheSameEvents) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 5.2268, 30.5346]\ndamping_ratios = [0.073, 0.07, 0.02]\n"
      "participation = [0.416, -0.631, 0.848]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.7363\nphase = 1.3\n"
      "[[stop]]\nshape = [1.116, -1.081, 0.984]\ngap = 0.079\nrestitution = 0.2\n"
      "[[stop]]\nshape = [1.199, -0.637, 1.088]\ngap = 1.113\nside = \"below\"\n"
      "restitution = 0.2\n",
      "three_modes.toml");
  for (const double step : {0.0078, 0.001}) {
    SCOPED_TRACE(step);
    const OrbitBranches result = support::trace_from_runs(
        scene, "modal.damping_ratios.1", {.from = 0.215, .to = 0.24, .max_step = step});
    for (const double value : {0.2313801370107, 0.2336519527113})
      EXPECT_TRUE(std::any_of(result.branches.begin(), result.branches.end(),
                              [&](const OrbitBranch& branch) {
                                return std::any_of(
                                    branch.special.begin(), branch.special.end(),
                                    [&](const SpecialPoint& special) {
                                      return std::abs(special.at.value / value - 1.0) < 1e-9;
                                    });
                              }))
          << value;
    for (const OrbitBranch& branch : result.branches)
      for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
        const OrbitBranchPoint &a = branch.points[i], &b = branch.points[i + 1];
        if ((a.value - 0.2334) * (b.value - 0.2334) < 0.0) {
          EXPECT_FALSE(a.orbit.stable == true && b.orbit.stable == true) << a.value;
        }
      }
  }
}

}  // namespace
}  // namespace graze
