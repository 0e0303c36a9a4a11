// Whether the orbits at special points are stable, on branches of every kind of orbit: there a
// multiplier lies on the unit circle, whatever rounding makes of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "branch_checks.hpp"
#include "graze/bifurcation/problem/detail/special_names.hpp"

namespace graze {
namespace {

struct Traced {
  const char* scene;
  std::vector<std::string> settings;
  BranchOptions options;
  std::vector<SpecialKind> kinds;  // that are met
};

// Names tests.
void PrintTo(const Traced& traced, std::ostream* out) { *out << traced.scene; }

// A special point says between which values it lies, and that it was met to the last digits.
void expect_enclosed(const SpecialPoint& special, double width) {
  const std::optional<Bracket>& bracket = special.solution.bracket;
  ASSERT_TRUE(bracket);
  EXPECT_TRUE(bracket->converged);
  EXPECT_LE(bracket->from, special.at.value);
  EXPECT_GE(bracket->to, special.at.value);
  EXPECT_LE(bracket->to - bracket->from, width);
}

class CriticalStability : public ::testing::TestWithParam<Traced> {};

// As many multipliers lie outside as on the side that has fewer of them: neighbours with no other
// special point between tell.
TEST_P(CriticalStability, IsUndecidedOrThatOfTheOtherMultipliers) {
  const auto& [name, settings, options, kinds] = GetParam();
  const SystemFamily family(support::shipped_scene(name, settings), "forcing.frequency");
  const OrbitBranches result = trace_orbits(family, options);
  std::vector<SpecialKind> met;
  for (const OrbitBranch& branch : result.branches) {
    const auto special_at = [&](std::size_t i) {
      return std::find_if(branch.special.begin(), branch.special.end(),
                          [&](const SpecialPoint& special) {
                            return special.at.value == branch.points[i].value &&
                                   special.at.orbit.impacts.front().phase ==
                                       branch.points[i].orbit.impacts.front().phase;
                          });
    };
    for (std::size_t i = 1; i + 1 < branch.points.size(); ++i) {
      const auto special = special_at(i);
      if (special == branch.special.end() ||
          std::find(kinds.begin(), kinds.end(), special->kind) == kinds.end())
        continue;
      SCOPED_TRACE(special->id + " at " + std::to_string(special->at.value));
      expect_enclosed(*special, 1e-9 * std::abs(options.to - options.from));
      met.push_back(special->kind);
      EXPECT_NE(branch.points[i].orbit.stable, true);
      EXPECT_EQ(branch.points[i].orbit.stable, special->at.orbit.stable);
      if (special_at(i - 1) != branch.special.end() || special_at(i + 1) != branch.special.end())
        continue;
      const int outside = std::min(branch.points[i - 1].unstable_multipliers,
                                   branch.points[i + 1].unstable_multipliers);
      EXPECT_EQ(branch.points[i].unstable_multipliers, outside);
      if (outside == 0) {
        EXPECT_EQ(branch.points[i].orbit.stable, std::nullopt);
      }
    }
  }
  for (const SpecialKind kind : kinds)
    EXPECT_NE(std::find(met.begin(), met.end(), kind), met.end()) << label_of(kind);
}

INSTANTIATE_TEST_SUITE_P(
    Orbits, CriticalStability,
    ::testing::Values(Traced{"04_impact_oscillator",
                             {"forcing.frequency=2.4", "stop.gap=0.0"},
                             {.from = 1.5, .to = 3.2, .start_values = 2, .sticking = false},
                             {SpecialKind::kPeriodDoubling}},
                      Traced{"04_impact_oscillator",
                             {"forcing.frequency=2.4", "stop.gap=0.8"},
                             {.from = 0.6, .to = 3.2, .start_values = 2, .sticking = false},
                             {SpecialKind::kFold}},
                      Traced{"09_soft_stop_two_modes",
                             {"forcing.frequency=40"},
                             {.from = 37.8, .to = 40.6, .max_step = 0.05, .start_values = 1},
                             {SpecialKind::kTorus, SpecialKind::kPeriodDoubling}},
                      Traced{"12_spring_dashpot_oscillator",
                             {"forcing.frequency=2.4", "stop.gap=0.0"},
                             {.from = 2.3, .to = 2.8, .start_values = 1},
                             {SpecialKind::kPeriodDoubling}}));

}  // namespace
}  // namespace graze
