// What modes, the summing of chatters and Newton's steps cost: errors, not times.
#include "graze/study/cost/accuracy_costs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

TEST(ModeCosts, TruncationFallsWithTheModes) {
  const Scene scene = support::shipped_scene("02_wagg_momentum", {"stop.gap=5e-3"});
  const std::vector<ModeCost> rows = mode_costs(scene, {2.0});
  ASSERT_GE(rows.size(), 8u);
  EXPECT_EQ(rows.front().modes, 1);
  // The frequencies of a cantilever grow as N^2, its participations fall as 1/N: the tip's error
  // falls at least as fast as N^-3.
  const double first = rows.front().error.value_or(0.0), last = rows.back().error.value_or(1.0);
  EXPECT_GT(first, 0.0);
  EXPECT_LT(last, first * std::pow(rows.back().modes, -3.0));
}

// The collocation impulse needs its stop at a collocation point i L/N: at L/2 where N is even.
TEST(ModeCosts, LeaveOutNumbersThatTheSceneDoesNotAllow) {
  const Scene scene = support::shipped_scene("01_wagg_2004", {"stop.position=0.15"});
  const std::vector<ModeCost> rows = mode_costs(scene, {0.5});
  ASSERT_FALSE(rows.empty());
  for (const ModeCost& row : rows) EXPECT_EQ(row.modes % 2, 0) << row.modes;
}

TEST(ModeCosts, TellTheScenesOwnNumber) {
  const Scene scene = support::shipped_scene("02_wagg_momentum", {"beam.modes=7", "stop.gap=5e-3"});
  int own = 0;
  for (const ModeCost& row : mode_costs(scene, {0.5})) own += row.modes == 7 ? 1 : 0;
  EXPECT_EQ(own, 1);
}

TEST(ModeCosts, NothingWhereTheirNumberIsNotFree) {
  EXPECT_TRUE(mode_costs(support::shipped_scene("04_impact_oscillator"), {10.0}).empty());
}

// The error of a summed tail is of second order in its speed.
TEST(ClosureCosts, ErrorFallsWithTheSquareOfTheSpeed) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const System system = assemble(scene);
  const ClosureCosts costs = closure_costs(system, initial_state(scene, system), {2.5});
  EXPECT_TRUE(costs.message.empty());
  const std::vector<ClosureCost>& rows = costs.rows;
  ASSERT_EQ(rows.size(), 8u);
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_GE(rows[i].impacts_per_period, rows[i - 1].impacts_per_period);
  ASSERT_TRUE(rows[0].compared.error && rows[2].compared.error && rows.back().compared.error);
  // From v_c to v_c/30: 1/900 of the error, the rest left for what is no power.
  EXPECT_LT(*rows[2].compared.error, *rows[0].compared.error / 100.0);
  EXPECT_LT(*rows.back().compared.error, 1e-12);
}

TEST(ClosureCosts, NothingWithoutChatter) {
  const Scene scene = support::shipped_scene("05_wagg_one_mode");
  const System system = assemble(scene);
  EXPECT_TRUE(closure_costs(system, initial_state(scene, system), {2.0}).rows.empty());
}

TEST(CorrectorCosts, EachStepSquaresTheError) {
  const Scene scene = support::shipped_scene("02_wagg_momentum", {"stop.gap=5e-3"});
  const CorrectorCosts costs = corrector_costs(scene, {});
  EXPECT_TRUE(costs.message.empty());
  for (const bool predicted : {false, true}) {
    std::vector<double> errors;
    for (const CorrectorCost& row : costs.rows)
      if (row.predicted == predicted) errors.push_back(row.error);
    ASSERT_GE(errors.size(), 3u);
    EXPECT_LT(errors.back(), 1e-13);
    // log(error) doubles: more than half again in one step, far from the last digits.
    for (std::size_t i = 1; i < errors.size() && errors[i] > 1e-12; ++i)
      EXPECT_LT(std::log(errors[i]), 1.4 * std::log(errors[i - 1]));
  }
}

TEST(CorrectorCosts, SayWhyThereAreNone) {
  EXPECT_NE(corrector_costs(support::shipped_scene("06_bouncing_ball"), {}).message.find("forcing"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
