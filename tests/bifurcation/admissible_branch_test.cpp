// Branches as they are listed: orbits of the system only, ended by the grazing where they cease.
#include <gtest/gtest.h>

#include <cmath>

#include "branch_checks.hpp"
#include "graze/orbit/problem/detail/solve.hpp"

namespace graze {
namespace {

using support::special_points;
using support::trace;

void expect_admissible_branches(const Scene& scene, const std::string& parameter, double from,
                                double to) {
  const OrbitBranches result = trace(scene, parameter, from, to, false);
  ASSERT_FALSE(result.branches.empty());
  for (const OrbitBranch& branch : result.branches) {
    SCOPED_TRACE(testing::Message() << "branch " << branch.id);
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const OrbitBranchPoint& point = branch.points[i];
      // The ends may be grazings themselves, on the boundary within their accuracy.
      const bool grazing_end =
          (i == 0 && branch.ends[0] == OrbitBranchEnd::kGrazing) ||
          (i + 1 == branch.points.size() && branch.ends[1] == OrbitBranchEnd::kGrazing);
      if (!grazing_end) {
        EXPECT_TRUE(point.orbit.admissible) << "at " << point.value;
      }
      EXPECT_GT(point.smallest_speed, -1e-9) << "at " << point.value;
      EXPECT_GT(point.orbit.clearance.value_or(1.0), -1e-10) << "at " << point.value;
    }
    for (const OrbitBranchEnd end : branch.ends)
      EXPECT_TRUE(end == OrbitBranchEnd::kParameterLimit || end == OrbitBranchEnd::kClosed ||
                  end == OrbitBranchEnd::kGrazing)
          << static_cast<int>(end);
    int grazings = 0;
    for (const SpecialPoint& special : branch.special) {
      if (special.kind != SpecialKind::kGrazing) continue;
      ++grazings;
      const double grazing =
          special.by_speed ? special.at.smallest_speed : special.at.orbit.clearance.value_or(1.0);
      EXPECT_NEAR(grazing, 0.0, 1e-9) << special.id;
    }
    const int ends =
        (branch.ends[0] == OrbitBranchEnd::kGrazing) + (branch.ends[1] == OrbitBranchEnd::kGrazing);
    EXPECT_EQ(grazings, ends);
  }
}

TEST(AdmissibleBranches, OfTheImpactOscillator) {
  const Scene scene = support::shipped_scene("04_impact_oscillator");
  expect_admissible_branches(scene, "forcing.frequency", 1.6, 4.0);
  expect_admissible_branches(scene, "stop.gap", -0.4, 0.4);
}

TEST(AdmissibleBranches, OfTheBeamWithOneTwoAndFourModes) {
  for (const int modes : {1, 2, 4}) {
    SCOPED_TRACE(modes);
    const Scene scene =
        support::shipped_scene("05_wagg_one_mode", {"beam.modes=" + std::to_string(modes)});
    expect_admissible_branches(scene, "forcing.frequency", 15.0, 120.0);
  }
}

// Every admissible solution of the closed form on a grid lies on a listed branch, and nothing else.
void expect_complete(const Scene& scene, const std::string& parameter, double from, double to) {
  const OrbitBranches result = trace(scene, parameter, from, to, false);
  const SystemFamily family(scene, parameter);
  for (int i = 1; i < 499; ++i) {
    const double value = from + (to - from) * i / 499.0;
    const System system = *family.at(value);
    const ClosedFormAnswer answer = closed_form(system, 0, 1);
    if (!answer.form) continue;
    int admissible = 0;
    bool boundary = false;  // too near to a grazing or a fold for the grid
    for (const ImpactPoint& point : answer.form->solutions(system.stops[0].gap)) {
      const Admissibility classification = admissibility(system, {1, {0}}, {point});
      admissible += classification.admissible;
      boundary = boundary || std::abs(classification.smallest_speed) < 1e-9 ||
                 std::abs(classification.clearance().value_or(1.0)) < 1e-9;
    }
    boundary = boundary ||
               std::abs(support::fold_distance(family, value)->relative()) < support::kBesideFold;
    if (!boundary) {
      EXPECT_EQ(support::segments(result, value), admissible) << value;
    }
  }
}

TEST(AdmissibleBranches, LeaveNoOrbitOutAndNoneIn) {
  expect_complete(support::shipped_scene("04_impact_oscillator"), "forcing.frequency", 1.6, 4.0);
  for (const int modes : {1, 2, 4}) {
    SCOPED_TRACE(modes);
    expect_complete(
        support::shipped_scene("05_wagg_one_mode", {"beam.modes=" + std::to_string(modes)}),
        "forcing.frequency", 15.0, 120.0);
  }
}

// P3, x'' + .1 x' + x = A cos t, stop 1, r = .8: fold and grazing 3e-5 apart, in order.
TEST(AdmissibleBranches, FoldAndGrazingSideBySideAreBothNamed) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.05]\nparticipation = [1.0]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 0.2\nfrequency = 1.0\n"
      "[[stop]]\nshape = [1.0]\ngap = 1.0\nrestitution = 0.8\n",
      "coco.toml");
  const OrbitBranches result = trace(scene, "forcing.amplitude", 0.05, 0.2, false);
  const OrbitBranch* with_fold = nullptr;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == SpecialKind::kFold) with_fold = &branch;
  ASSERT_TRUE(with_fold);
  ASSERT_EQ(with_fold->special.size(), 2u);
  const bool fold_first = with_fold->special[0].kind == SpecialKind::kFold;
  const SpecialPoint& fold = with_fold->special[fold_first ? 0 : 1];
  const SpecialPoint& grazing = with_fold->special[fold_first ? 1 : 0];
  ASSERT_EQ(fold.kind, SpecialKind::kFold);
  ASSERT_EQ(grazing.kind, SpecialKind::kGrazing);
  EXPECT_NEAR(fold.at.value, 0.0999707536283, 1e-11);
  EXPECT_NEAR(fold.at.orbit.impacts[0].speed, 0.00411153064, 1e-8);
  EXPECT_NEAR(grazing.at.value, 0.1, 1e-10);
  EXPECT_TRUE(grazing.by_speed);
}

// G2, x'' + .1 x' + x = F cos(1.6 t), a = .5, r = .8: both branches, fold and grazing.
TEST(AdmissibleBranches, LowSpeedBranchEndsAtItsGrazing) {
  const Scene scene = support::reference_scene("orbits/sdof_1_6");
  const OrbitBranches result = trace(scene, "forcing.amplitude", 0.2, 1.0, false);
  const auto grazings = special_points(result, SpecialKind::kGrazing);
  const auto folds = special_points(result, SpecialKind::kFold);
  ASSERT_EQ(folds.size(), 1u);
  const double force = 0.784091831356506353;
  EXPECT_NEAR(folds[0]->at.value / (force * 0.352831175746127748), 1.0, 1e-10);
  ASSERT_EQ(grazings.size(), 1u);
  EXPECT_NEAR(grazings[0]->at.value / force, 1.0, 1e-10);
  EXPECT_TRUE(grazings[0]->by_speed);
  EXPECT_LE(std::abs(grazings[0]->at.smallest_speed), 1e-8);
}

// Two stops side by side: the structure cannot hit the one that lies behind the other. At equal
// gaps it is turned back from both, in a corner of either gap that is no minimum of a flight.
TEST(AdmissibleBranch, EndsWhereItsStopFallsBehindAnother) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.05]\nparticipation = [1.0]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 1.6\n"
      "[[stop]]\nshape = [1.0]\ngap = 0.5\nrestitution = 0.7\n"
      "[[stop]]\nshape = [1.0]\ngap = 0.3\nrestitution = 0.7\n",
      "side_by_side.toml");
  const SystemFamily family(scene, "stop.1.gap");
  BranchOptions options;
  options.from = 0.2;
  options.to = 0.6;
  const OrbitBranches result = trace_orbits(family, options);
  ASSERT_EQ(result.branches.size(), 2u);
  for (const OrbitBranch& branch : result.branches) {
    const int stop = branch.pattern.stops.at(0);
    for (const OrbitBranchPoint& point : branch.points)
      EXPECT_TRUE(stop == 0 ? point.value <= 0.3 * (1.0 + 1e-12)
                            : point.value >= 0.3 * (1.0 - 1e-12))
          << point.value;
    ASSERT_EQ(branch.special.size(), 1u);
    EXPECT_EQ(branch.special[0].kind, SpecialKind::kGrazing);
    EXPECT_NEAR(branch.special[0].at.value, 0.3, 1e-12);
  }
}

}  // namespace
}  // namespace graze
