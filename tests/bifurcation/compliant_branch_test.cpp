// Branches of orbits on compliant stops: against rigid stops, at their grazings, and onward.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "branch_checks.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

Scene oscillator(const std::string& spring) {
  return support::shipped_scene("12_spring_dashpot_oscillator",
                                {"stop.spring={" + spring + "}", "forcing.frequency=2.4"});
}

OrbitBranches traced(const Scene& scene, double from, double to, int depth = 0) {
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = from;
  options.to = to;
  options.start_values = 2;
  options.follow_depth = depth;
  return trace_orbits(family, options);
}

std::vector<SpecialPoint> special_of(const OrbitBranches& result, SpecialKind kind) {
  std::vector<SpecialPoint> list;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == kind) list.push_back(special);
  return list;
}

double doubling(const Scene& scene) {
  const std::vector<SpecialPoint> found =
      special_of(traced(scene, 2.3, 2.8), SpecialKind::kPeriodDoubling);
  EXPECT_EQ(found.size(), 1u);
  return found.empty() ? 0.0 : found.front().at.value;
}

// The period doubling of the oscillator against a rigid stop with r = 0.8 is what that of stiffer
// and stiffer stops with the same restitution tends to, as the time of their contacts falls: as
// k^(-1/2), so that the limit is told by two of them up to a part of order 1/k.
TEST(CompliantBranches, DoublingTendsToThatOfTheRigidStop) {
  const std::string damping =
      ",exponent=1.0,damping={model=\"kelvin-voigt\",restitution=0.8,mass=1.0,inversion=\"exact\"}";
  const double soft = doubling(oscillator("stiffness=1e4" + damping)),
               stiff = doubling(oscillator("stiffness=1e6" + damping));
  const double rigid = doubling(
      support::shipped_scene("04_impact_oscillator", {"forcing.frequency=2.4", "stop.gap=0.0"}));
  EXPECT_GT(std::abs(soft - rigid), 1e-3);
  EXPECT_NEAR((stiff - rigid) / (soft - rigid), 0.1, 0.01);
  EXPECT_NEAR(stiff + (stiff - soft) / 9.0, rigid, 2e-2 * std::abs(stiff - rigid));
}

// Where a branch of two contacts grazes, one of them is lost: on either side the orbits that are
// found without it have one more, or one less, and at it a contact has no speed.
TEST(CompliantBranches, PassGrazingsOfSmoothForces) {
  const Scene scene =
      oscillator("stiffness=400.0,exponent=1.0,damping={model=\"hunt-crossley\",alpha=0.6}");
  const OrbitBranches result = traced(scene, 1.8, 4.5, 1);
  const std::vector<SpecialPoint> grazings = special_of(result, SpecialKind::kGrazing);
  ASSERT_EQ(grazings.size(), 2u);  // of the two parts that meet there
  EXPECT_DOUBLE_EQ(grazings[0].at.value, grazings[1].at.value);
  const double value = grazings[0].at.value;
  const SystemFamily family(scene, "forcing.frequency");
  for (const double side : {-1e-4, 1e-4}) {
    const System system = *family.at(value + side);
    const MotionState<double>& at = grazings[0].at.orbit.section->states[0];
    const FollowedAnswer near = followed_orbit(system, {at.q, at.qdot}, 2, SegmentOptions{});
    ASSERT_TRUE(near.orbit) << near.why_not;
    EXPECT_EQ(near.orbit->impacts.size(), side < 0.0 ? 2u : 1u);
    if (side < 0.0) {
      // The speed that is lost goes as the root of the distance.
      double slowest = 1.0;
      for (const OrbitImpact& impact : near.orbit->impacts)
        slowest = std::min(slowest, impact.speed);
      EXPECT_LT(slowest, 0.05);
      EXPECT_GT(slowest, 1e-4);
    } else {
      ASSERT_TRUE(near.orbit->clearance);
      EXPECT_LT(*near.orbit->clearance, 1e-3);
      EXPECT_GT(*near.orbit->clearance, 0.0);
    }
  }
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranchPoint& point : branch.points)
      if (point.value != value) {
        EXPECT_EQ(static_cast<int>(point.orbit.impacts.size()), branch.pattern.impacts());
      }
}

// A force that sets in with a jump and is released at zero makes a corner there: the branch ends.
// Beside the grazing that this branch begins with its multiplier runs from far below -1 to it
// within less than the branch resolves; no doubling is told that is none.
TEST(CompliantBranches, DoublingsHaveAMultiplierOfMinusOne) {
  const Scene scene = support::shipped_scene(
      "13_beam_on_a_spring",
      {"beam.modes=1", "stop.spring={stiffness=1e7,exponent=1.0}", "forcing.frequency=20.0"});
  for (const double to : {20.0, 21.0}) {
    const std::vector<SpecialPoint> doublings =
        special_of(traced(scene, 19.5, to), SpecialKind::kPeriodDoubling);
    EXPECT_EQ(doublings.size(), to > 20.5 ? 1u : 0u);
    for (const SpecialPoint& doubling : doublings) {
      ASSERT_TRUE(doubling.multiplier);
      EXPECT_NEAR(doubling.multiplier->real(), -1.0, 1e-3) << doubling.at.value;
    }
  }
}

TEST(CompliantBranches, EndAtGrazingsOfForcesThatJump) {
  const OrbitBranches result = traced(
      oscillator("stiffness=400.0,exponent=1.0,damping={model=\"kelvin-voigt\",coefficient=2.8}"),
      1.8, 4.5, 1);
  ASSERT_EQ(result.branches.size(), 2u);
  const OrbitBranch& doubled = result.branches[1];
  EXPECT_EQ(doubled.pattern.period, 2);
  EXPECT_EQ(doubled.origin, "PD1");
  EXPECT_EQ(doubled.ends[0], OrbitBranchEnd::kPeriodDoubling);
  EXPECT_EQ(doubled.ends[1], OrbitBranchEnd::kGrazing);
  EXPECT_LT(special_of(result, SpecialKind::kGrazing).back().at.smallest_speed, 1e-5);
  EXPECT_EQ(result.cut_short, 0);
}

// Every orbit of a branch is one: its motion repeats, and its multipliers multiply to what the
// damping leaves of a volume, by the structure's own decay and the stop's while it is loaded.
TEST(CompliantBranches, OrbitsRepeatAndShrinkVolumesByTheirDamping) {
  const double coefficient = 2.8;
  const Scene scene =
      oscillator("stiffness=400.0,exponent=1.0,damping={model=\"kelvin-voigt\",coefficient=2.8}");
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result = traced(scene, 1.8, 3.0, 1);
  ASSERT_EQ(result.branches.size(), 2u);
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranchPoint& point : branch.points) {
      const System system = *family.at(point.value);
      double loaded = 0.0;
      for (const OrbitImpact& impact : point.orbit.impacts) loaded += impact.contact->duration;
      const double shrinks =
          2.0 * system.delta()[0] * point.orbit.period * system.period() + coefficient * loaded;
      double product = 1.0;
      for (const Eigenvalue& multiplier : point.orbit.multipliers)
        product *= std::abs(multiplier.value);
      EXPECT_NEAR(product, std::exp(-shrinks), 1e-8);
    }
}

// The phase of the forcing moves nothing but the clock: an orbit is the same at all of them, so far
// into the forcing's turn, wherever the scene's own phase is.
TEST(CompliantBranches, AreTheSameAtEveryPhaseOfTheForcing) {
  Scene scene =
      oscillator("stiffness=400.0,exponent=1.0,damping={model=\"hunt-crossley\",alpha=0.6}");
  scene.forcing->phase = -2.0;
  const SystemFamily family(scene, "forcing.phase");
  BranchOptions options;
  options.from = 0.0;
  options.to = 1.0;
  options.start_values = 2;
  options.finder.from_random = false;
  const OrbitBranches result = trace_orbits(family, options);
  ASSERT_EQ(result.branches.size(), 1u);
  const std::vector<OrbitBranchPoint>& points = result.branches.front().points;
  EXPECT_NEAR(std::abs(points.front().value - points.back().value), 1.0, 1e-12);
  for (const OrbitBranchPoint& point : points) {
    EXPECT_NEAR(point.orbit.impacts.front().phase, points.front().orbit.impacts.front().phase,
                1e-9);
    EXPECT_NEAR(point.orbit.impacts.front().speed, points.front().orbit.impacts.front().speed,
                1e-9);
  }
}

// Between equal stops an orbit may be its own mirror image: the other stop is met half a period
// later, as fast. Where that symmetry is lost two branches of orbits that mirror each other leave,
// which is a branch point of the one that goes on.
TEST(CompliantBranches, GoOnWhereTheirSymmetryIsLost) {
  std::string text = R"(
[modal]
frequencies = [1.0]
damping_ratios = [0.05]
participation = [1.0]

[forcing]
kind = "modal"
amplitude = 1.0
frequency = 1.3
)";
  for (const char* side : {"above", "below"})
    text += std::string("[[stop]]\nshape = [1.0]\ngap = 0.2\nside = \"") + side + R"("
[stop.spring]
stiffness = 10.0
exponent = 1.5
damping = { model = "hunt-crossley", alpha = 0.2 }
)";
  const SystemFamily family(parse_scene(text, "two_sides"), "forcing.frequency");
  BranchOptions options;
  options.from = 1.0;
  options.to = 1.4;
  options.impacts = 2;
  options.start_values = 0;
  options.finder.from_random = false;
  const OrbitBranches result = trace_orbits(family, options);
  EXPECT_EQ(result.cut_short, 0);
  ASSERT_EQ(result.branches.size(), 1u);
  const OrbitBranch& branch = result.branches.front();
  EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kParameterLimit);
  EXPECT_EQ(branch.ends[1], OrbitBranchEnd::kParameterLimit);
  const std::vector<SpecialPoint> lost = special_of(result, SpecialKind::kBranchPoint);
  ASSERT_EQ(lost.size(), 1u);
  const double pi = std::acos(-1.0);
  for (const OrbitBranchPoint& point : branch.points) {
    const std::vector<OrbitImpact>& impacts = point.orbit.impacts;
    ASSERT_EQ(impacts.size(), 2u);
    EXPECT_NE(impacts[0].stop, impacts[1].stop);
    // Beside the branch point they are known to the accuracy of the map over the distance.
    EXPECT_NEAR(impacts[0].speed, impacts[1].speed, 1e-5) << point.value;
    EXPECT_NEAR(impacts[1].phase - impacts[0].phase, pi, 1e-5) << point.value;
    // Stable on one side alone.
    if (std::abs(point.value - lost[0].at.value) > 1e-3) {
      EXPECT_EQ(point.orbit.stable, point.value > lost[0].at.value) << point.value;
    }
  }
}

}  // namespace
}  // namespace graze
