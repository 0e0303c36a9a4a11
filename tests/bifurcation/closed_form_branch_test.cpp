// Whole components of (1, 1) solutions over a parameter, virtual parts included: every point, every
// fold, and nothing left out. The closed form is the referee.
#include <gtest/gtest.h>

#include "branch_checks.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

using support::expect_closed_form;
using support::fold_distance;
using support::FoldDistance;
using support::kBesideFold;
using support::segments;
using support::special_points;
using support::trace;

struct Sweep {
  std::string scene, parameter;
  double from, to;
  int modes = 0;  // of the beam; 0: as in the scene
};

void PrintTo(const Sweep& sweep, std::ostream* stream) {
  *stream << sweep.scene << " " << sweep.parameter << " N=" << sweep.modes;
}

class WholeComponents : public testing::TestWithParam<Sweep> {
 protected:
  Scene scene() const {
    std::vector<std::string> settings;
    if (GetParam().modes > 0) settings.push_back("beam.modes=" + std::to_string(GetParam().modes));
    return support::shipped_scene(GetParam().scene, settings);
  }
  OrbitBranches traced() const {
    return trace(scene(), GetParam().parameter, GetParam().from, GetParam().to, true);
  }
  SystemFamily family() const { return {scene(), GetParam().parameter}; }
};

TEST_P(WholeComponents, EveryPointIsASolutionOfTheClosedForm) {
  const OrbitBranches result = traced();
  EXPECT_GT(expect_closed_form(result, family()), 50);
  for (const OrbitBranch& branch : result.branches) {
    for (const OrbitBranchPoint& point : branch.points) {
      EXPECT_GE(point.value, GetParam().from);
      EXPECT_LE(point.value, GetParam().to);
    }
    for (const OrbitBranchEnd end : branch.ends)
      EXPECT_TRUE(end == OrbitBranchEnd::kParameterLimit || end == OrbitBranchEnd::kClosed)
          << "branch " << branch.id << " ends " << static_cast<int>(end);
  }
}

TEST_P(WholeComponents, FoldsStandWhereKappaIsTheGap) {
  const OrbitBranches result = traced();
  const SystemFamily systems = family();
  for (const SpecialPoint* fold : special_points(result, SpecialKind::kFold)) {
    const auto distance = fold_distance(systems, fold->at.value);
    ASSERT_TRUE(distance);
    EXPECT_NEAR(distance->relative(), 0.0, 1e-10) << fold->id << " at " << fold->at.value;
    ASSERT_TRUE(fold->multiplier);
    // A multiplier leaves 1 with the square root of the distance.
    EXPECT_LE(std::abs(*fold->multiplier - 1.0), 1e-4) << fold->id;
  }
}

TEST_P(WholeComponents, NoFoldIsMissedAndNoneIsDoubled) {
  const OrbitBranches result = traced();
  const SystemFamily systems = family();
  constexpr int kSamples = 20'000;
  std::vector<double> crossings;  // middle of the samples between which |kappa| meets the gap
  std::optional<FoldDistance> before;
  for (int i = 0; i <= kSamples; ++i) {
    const double value = GetParam().from + (GetParam().to - GetParam().from) * i / kSamples;
    const auto here = fold_distance(systems, value);
    if (here && before && here->relative() * before->relative() < 0.0) crossings.push_back(value);
    before = here;
  }
  const auto folds = special_points(result, SpecialKind::kFold);
  EXPECT_EQ(folds.size(), crossings.size());
  const double spacing = (GetParam().to - GetParam().from) / kSamples;
  for (const double crossing : crossings) {
    int near = 0;
    for (const SpecialPoint* fold : folds)
      near += fold->at.value >= crossing - 1.01 * spacing && fold->at.value <= crossing;
    EXPECT_EQ(near, 1) << "fold near " << crossing;
  }
}

TEST_P(WholeComponents, BothSolutionsAreTracedWhereverThereAreTwo) {
  const OrbitBranches result = traced();
  const SystemFamily systems = family();
  for (int i = 1; i < 997; ++i) {
    const double value = GetParam().from + (GetParam().to - GetParam().from) * i / 997.0;
    const auto distance = fold_distance(systems, value);
    if (!distance || std::abs(distance->relative()) < kBesideFold) continue;
    EXPECT_EQ(segments(result, value), distance->relative() > 0.0 ? 2 : 0) << value;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, WholeComponents,
    testing::Values(Sweep{"04_impact_oscillator", "forcing.frequency", 1.6, 4.0},
                    Sweep{"04_impact_oscillator", "stop.gap", -0.4, 0.4},
                    Sweep{"05_wagg_one_mode", "forcing.frequency", 20.0, 120.0, 1},
                    Sweep{"05_wagg_one_mode", "forcing.frequency", 20.0, 120.0, 2},
                    Sweep{"05_wagg_one_mode", "forcing.frequency", 20.0, 120.0, 4},
                    Sweep{"05_wagg_one_mode", "stop.gap", 2e-4, 2e-2, 1},
                    Sweep{"05_wagg_one_mode", "stop.gap", 2e-4, 2e-2, 2},
                    Sweep{"05_wagg_one_mode", "stop.gap", 2e-4, 2e-2, 4}));

TEST(Folds, AgreeWithTheReference) {
  for (const support::TableRow& row : support::read_table("closed_form_folds.csv")) {
    SCOPED_TRACE(row.at("case") + " " + row.at("parameter") + " " + row.at("value"));
    const double value = support::number(row, "value");
    const std::string& parameter = row.at("parameter");
    // One of these components is .065 rad/s wide: the scene itself is put next to the fold, on the
    // side where there are solutions.
    Scene scene = with_parameter(support::reference_scene("orbits/" + row.at("case")), parameter,
                                 value * (1.0 - 1e-3));
    if (fold_distance({scene, parameter}, value * (1.0 - 1e-3))->relative() < 0.0)
      scene = with_parameter(scene, parameter, value * (1.0 + 1e-3));
    const OrbitBranches result = trace(scene, parameter, 0.5 * value, 1.5 * value, true);
    const SpecialPoint* nearest = nullptr;
    for (const SpecialPoint* fold : special_points(result, SpecialKind::kFold))
      if (!nearest || std::abs(fold->at.value - value) < std::abs(nearest->at.value - value))
        nearest = fold;
    ASSERT_TRUE(nearest);
    EXPECT_NEAR(nearest->at.value / value, 1.0, 1e-10);
    // Phase and speed of a fold are known to the square root of what its value is.
    const OrbitImpact& impact = nearest->at.orbit.impacts[0];
    EXPECT_NEAR(
        std::remainder(impact.phase - support::number(row, "phase"), 2.0 * std::numbers::pi), 0.0,
        1e-5);
    EXPECT_NEAR(impact.speed / support::number(row, "speed"), 1.0, 1e-4);
  }
}

void expect_other_parameter(const Scene& scene, const std::string& parameter, double from,
                            double to) {
  SCOPED_TRACE(parameter);
  const OrbitBranches result = trace(scene, parameter, from, to, true);
  const SystemFamily family(scene, parameter);
  EXPECT_GT(expect_closed_form(result, family), 20);
  for (const SpecialPoint* fold : special_points(result, SpecialKind::kFold))
    EXPECT_NEAR(fold_distance(family, fold->at.value)->relative(), 0.0, 1e-10);
  for (int i = 1; i < 97; ++i) {
    const double value = from + (to - from) * i / 97.0;
    const auto distance = fold_distance(family, value);
    if (!distance || std::abs(distance->relative()) < support::kBesideFold) continue;
    EXPECT_EQ(segments(result, value), distance->relative() > 0.0 ? 2 : 0) << value;
  }
}

TEST(OtherParameters, OfABeamAgreeWithTheClosedForm) {
  const Scene scene = support::reference_scene("orbits/beam_n2_40");
  expect_other_parameter(scene, "damping.viscous", 0.0005, 0.1);
  expect_other_parameter(scene, "stop.restitution", 0.05, 1.0);
  expect_other_parameter(scene, "beam.density", 6000.0, 12000.0);
  expect_other_parameter(scene, "beam.length", 0.28, 0.32);
  expect_other_parameter(scene, "beam.youngs_modulus", 150e9, 250e9);
  expect_other_parameter(scene, "stop.position", 0.15, 0.3);
  expect_other_parameter(scene, "forcing.amplitude", 1e-4, 2e-3);
}

TEST(OtherParameters, OfGivenModesAgreeWithTheClosedForm) {
  const Scene scene = support::reference_scene("orbits/three_modes_2_1");
  expect_other_parameter(scene, "modal.frequencies.1", 0.8, 1.3);
  expect_other_parameter(scene, "modal.damping_ratios.2", 0.0, 0.1);
  expect_other_parameter(scene, "stop.shape.3", 1.0, 3.0);
}

TEST(OtherParameters, ThePhaseOfTheForcingChangesNothing) {
  const Scene scene = support::reference_scene("orbits/sdof_1_6");
  const OrbitBranches result = trace(scene, "forcing.phase", 0.0, 3.0, true);
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranchPoint& point : branch.points)
      EXPECT_NEAR(point.orbit.impacts[0].phase, branch.points[0].orbit.impacts[0].phase, 1e-12);
}

TEST(OtherParameters, TwoPeriodsPerImpactAgreeWithTheClosedForm) {
  const Scene scene = support::reference_scene("orbits/sdof_2_8_period2");
  const OrbitBranches result = trace(scene, "forcing.frequency", 2.0, 4.0, true, 2);
  const SystemFamily family(scene, "forcing.frequency");
  EXPECT_GT(expect_closed_form(result, family, 2), 50);
}

}  // namespace
}  // namespace graze
