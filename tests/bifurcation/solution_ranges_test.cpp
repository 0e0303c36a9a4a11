// Intervals of values with (p, 1) solutions: the closed form, value by value, is the referee.
#include "graze/bifurcation/bounds/detail/solution_ranges.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "branch_checks.hpp"
#include "graze/bifurcation/bounds/detail/one_impact_form.hpp"

namespace graze {
namespace {

struct Survey {
  std::string scene, parameter;
  double from, to;
  std::vector<std::string> settings{};
  int period = 1;
};

void PrintTo(const Survey& survey, std::ostream* stream) {
  *stream << survey.scene << " " << survey.parameter;
  for (const std::string& setting : survey.settings) *stream << " " << setting;
}

class Ranges : public testing::TestWithParam<Survey> {
 protected:
  SystemFamily family() const {
    return {support::shipped_scene(GetParam().scene, GetParam().settings), GetParam().parameter};
  }
};

bool solved(const SolutionRanges& ranges, double value) {
  bool inside = false;
  for (const SolutionRanges::Range& range : ranges.ranges())
    inside = inside || (value > range.from && value < range.to);
  return inside;
}

bool has_solutions(const SystemFamily& family, double value, int period) {
  const std::optional<System> system = family.at(value);
  if (!system) return false;
  const ClosedFormAnswer answer = closed_form(*system, 0, period);
  return answer.form && !answer.form->solutions(system->stops[0].gap).empty();
}

TEST_P(Ranges, HoldTheSolutionsOfTheClosedFormAndNothingElse) {
  const auto& [scene, parameter, from, to, settings, period] = GetParam();
  const SystemFamily systems = family();
  const SolutionRanges ranges(systems, 0, period, from, to);
  EXPECT_EQ(ranges.undecided(), 0);
  EXPECT_GT(ranges.evaluations(), 0);
  constexpr int kSamples = 2011;
  int compared = 0;
  for (int i = 1; i < kSamples; ++i) {
    const double value = from + (to - from) * i / kSamples;
    const std::optional<System> system = systems.at(value);
    if (!system) continue;
    const ClosedFormAnswer answer = closed_form(*system, 0, period);
    if (!answer.form) continue;
    ++compared;
    EXPECT_EQ(solved(ranges, value), !answer.form->solutions(system->stops[0].gap).empty())
        << value;
  }
  EXPECT_GT(compared, kSamples / 3);
  double last = from;
  for (const SolutionRanges::Range& range : ranges.ranges()) {
    EXPECT_GE(range.from, last);
    EXPECT_GT(range.to, range.from);
    last = range.to;
    for (const auto& [end, folds] :
         {std::pair(range.from, range.folds_at_start), std::pair(range.to, range.folds_at_end)}) {
      if (!folds) continue;
      // Of the two sides of a fold one has solutions, the other has none.
      const double away = 1e-7 * (to - from);
      EXPECT_NE(has_solutions(systems, end - away, period),
                has_solutions(systems, end + away, period))
          << end;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Ranges,
    testing::Values(
        Survey{"04_impact_oscillator", "forcing.frequency", 0.2, 4.0, {"stop.gap=0.7"}},
        Survey{"04_impact_oscillator", "forcing.frequency", 0.2, 4.0, {"stop.gap=0.7"}, 3},
        Survey{"04_impact_oscillator",
               "forcing.frequency",
               0.2,
               4.0,
               {"stop.gap=3.0", "modal.damping_ratios=[0.0]"}},
        Survey{"04_impact_oscillator",
               "forcing.frequency",
               0.2,
               4.0,
               {"stop.gap=0.7", "modal.damping_ratios=[1.7]"}},
        Survey{"04_impact_oscillator",
               "forcing.frequency",
               0.2,
               4.0,
               {"stop.gap=0.7", "modal.damping_ratios=[1.0]"}},
        Survey{"04_impact_oscillator", "modal.damping_ratios.1", 0.0, 3.0, {"stop.gap=0.3"}},
        Survey{"04_impact_oscillator", "modal.frequencies.1", 0.1, 9.0, {"stop.gap=0.3"}},
        Survey{"04_impact_oscillator", "stop.gap", -3.0, 3.0, {"forcing.frequency=0.37"}},
        Survey{"04_impact_oscillator",
               "stop.restitution",
               0.0,
               1.0,
               {"forcing.frequency=0.37", "stop.gap=1.5"}},
        Survey{
            "05_wagg_one_mode", "forcing.frequency", 20.0, 40.0, {"beam.modes=4", "stop.gap=5e-3"}},
        Survey{"05_wagg_one_mode", "beam.length", 0.25, 0.35, {"beam.modes=3", "stop.gap=5e-3"}},
        Survey{"05_wagg_one_mode", "stop.position", 0.05, 0.3, {"beam.modes=3", "stop.gap=2e-3"}},
        Survey{"05_wagg_one_mode", "damping.viscous", 0.0, 3.0, {"beam.modes=2", "stop.gap=2e-3"}},
        Survey{
            "06_bouncing_ball",
            "forcing.amplitude",
            1.0,
            6.0,
            {"forcing={kind='modal',amplitude=2.0,frequency=20.0}", "modal.participation=[1.0]"}},
        Survey{"07_two_stops", "forcing.frequency", 0.2, 4.0}));

// A ball on a vibrating table bounces once a period from an acceleration of pi g (1 - r)/(1 + r) on
// (P. J. Holmes, J. Sound Vib. 84, 1982, 173-189), whatever the frequency.
TEST(BallOnAVibratingTable, HasTheFoldOfTheTextbooks) {
  const SystemFamily family(
      support::shipped_scene(
          "06_bouncing_ball",
          {"forcing={kind='modal',amplitude=2.0,frequency=20.0}", "modal.participation=[1.0]"}),
      "forcing.amplitude");
  const SolutionRanges ranges(family, 0, 1, 1.0, 6.0);
  ASSERT_EQ(ranges.ranges().size(), 1u);
  EXPECT_TRUE(ranges.ranges()[0].folds_at_start);
  EXPECT_NEAR(ranges.ranges()[0].from, std::numbers::pi * 9.81 * 0.2 / 1.8, 1e-12);
  EXPECT_EQ(ranges.ranges()[0].to, 6.0);
}

// The same number along a solution as the value varies, other numbers for the two solutions.
TEST(Families, AreToldApartAlongTheRange) {
  const SystemFamily family(
      support::shipped_scene("04_impact_oscillator", {"stop.gap=0.1", "stop.restitution=0.95",
                                                      "modal.damping_ratios=[0.02]"}),
      "forcing.frequency");
  const SolutionRanges ranges(family, 0, 1, 1.2, 4.0);
  ASSERT_EQ(ranges.ranges().size(), 1u);
  ASSERT_FALSE(ranges.ranges()[0].folds());
  // Followed by their phases, in steps too short to mistake one for the other.
  std::vector<double> phases;
  std::vector<int> names;
  for (int i = 0; i <= 20'000; ++i) {
    const double value = 1.2 + 2.8 * i / 20'000;
    const System system = *family.at(value);
    const auto solutions = closed_form(system, 0, 1).form->solutions(system.stops[0].gap);
    ASSERT_EQ(solutions.size(), 2u);
    const auto distance = [](double a, double b) {
      return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
    };
    if (phases.empty()) {
      for (const ImpactPoint& point : solutions) {
        phases.push_back(point.theta);
        names.push_back(*ranges.component(value, point.theta));
      }
      ASSERT_NE(names[0], names[1]);
      continue;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const bool first =
          distance(solutions[0].theta, phases[k]) < distance(solutions[1].theta, phases[k]);
      phases[k] = solutions[first ? 0 : 1].theta;
      EXPECT_EQ(*ranges.component(value, phases[k]), names[k]) << value;
    }
  }
}

}  // namespace
}  // namespace graze
