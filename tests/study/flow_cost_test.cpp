// What accuracy costs: the table, not the times in it.
#include "graze/study/cost/flow_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/system/scale.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

FlowCosts costs_of(const Scene& scene, std::size_t impacts) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  FlowCostOptions options;
  options.impacts = impacts;
  options.longest = 100.0 * system.period();
  options.tolerance = 1e-8;
  options.row_seconds = 0.02;
  options.speed = modal_speed(system, start);
  options.closure_speed = default_closure_speed(system, start);
  return flow_costs(system, start, options);
}

TEST(FlowCost, EveryFlowGetsBetterDownItsLadder) {
  const FlowCosts costs =
      costs_of(support::shipped_scene("02_wagg_momentum", {"stop.gap=5e-3"}), 10);
  EXPECT_EQ(costs.impacts, 10u);
  ASSERT_EQ(costs.rows.front().flow, "exact");
  EXPECT_LE(costs.rows.front().compared.error.value_or(1.0), 1e-10);
  for (const char* flow : {"rk4", "dopri5", "fehlberg78"}) {
    SCOPED_TRACE(flow);
    std::vector<const FlowCost*> rows;
    for (const FlowCost& row : costs.rows)
      if (row.flow == flow) rows.push_back(&row);
    ASSERT_GE(rows.size(), 2u);
    // The longest step there is loses the sequence of the fourth mode's impacts.
    EXPECT_GT(rows.back()->evaluations_per_period, rows.front()->evaluations_per_period);
    EXPECT_TRUE(rows.back()->compared.impacts_agree);
    EXPECT_LE(rows.back()->compared.error.value_or(1.0), 1e-5);
  }
  const FlowCost* best = cheapest(costs, 1e-8);
  ASSERT_TRUE(best);
  EXPECT_LE(*best->compared.error, 1e-8);
  for (const FlowCost& row : costs.rows) {
    if (!row.compared.error || *row.compared.error > 1e-8) continue;
    EXPECT_LE(best->seconds_per_period, row.seconds_per_period);
  }
  EXPECT_EQ(cheapest(costs, 0.0), nullptr);
}

// The response of a linear oscillator from rest, without any contact: errors are of displacements.
TEST(FlowCost, WithoutImpactsDisplacementsAreCompared) {
  const FlowCosts costs =
      costs_of(support::shipped_scene("04_impact_oscillator", {"stop.gap=50.0"}), 20);
  EXPECT_EQ(costs.impacts, 0u);
  ASSERT_FALSE(costs.rows.empty());
  EXPECT_LE(costs.rows.front().compared.error.value_or(1.0), 1e-13);
  EXPECT_NEAR(costs.allowed, 1e-8, 1e-20);
}

// Impacts in the tail of a chatter that double precision sums are not compared.
TEST(FlowCost, ChattersAreComparedUpToTheirTails) {
  const FlowCosts costs = costs_of(support::shipped_scene("09_soft_stop_two_modes"), 20);
  EXPECT_EQ(costs.impacts, 20u);
  EXPECT_TRUE(costs.rows.front().compared.impacts_agree);
  EXPECT_LE(costs.rows.front().compared.error.value_or(1.0), 1e-12);
}

// The reference against closed forms: a ball dropped from h meets the floor at sqrt(2 h/g) and then
// every 2 r^k sqrt(2 h/g).
TEST(ReferenceRun, BallFallsAsItShould) {
  System system = support::oscillator(0.0, 0.0, 1.0, 0.5);
  system.modal().load = Vector::Constant(1, 2.0);
  ReferenceOptions options;
  options.impacts = 5;
  options.longest = 10.0;
  const ReferenceRun run = reference_run(system, support::rest(system), options);
  ASSERT_EQ(run.impacts.size(), 5u);
  double time = 1.0, bounce = 2.0;
  for (const ReferenceImpact& impact : run.impacts) {
    EXPECT_NEAR(impact.time, time, 1e-15);
    EXPECT_NEAR(impact.speed, bounce, 1e-15);
    bounce *= 0.5;
    time += bounce;
  }
  // Half of the next flight on, at its highest point, at rest.
  EXPECT_NEAR(run.end_time, time - 0.5 * bounce, 1e-14);
  EXPECT_NEAR(run.end.qdot[0], 0.0, 1e-14);
}

// M6 of the catalogue: explicit steps beyond 2.828/w_N are refused with that limit.
TEST(StepChoice, RefusesStepsThatAreNotStable) {
  const std::vector<std::string> common = {
      "modal.frequencies=[3.0, 40.0]", "modal.participation=[1.0, 1.0]", "stop.shape=[1.0, 1.0]",
      "initial.q=[0.0, 0.0]", "initial.qdot=[0.0, 0.0]"};
  const auto choice = [&](const std::string& flow, const std::string& step) {
    std::vector<std::string> settings = common;
    settings.push_back("solver.flow=\"" + flow + "\"");
    if (!step.empty()) settings.push_back("solver.step=" + step);
    settings.push_back("modal.damping_ratios=[0.0, 0.0]");
    const Scene scene = support::shipped_scene("04_impact_oscillator", settings);
    const System system = assemble(scene);
    return step_choice(scene, system, initial_state(scene, system));
  };
  EXPECT_TRUE(choice("rk4", "0.0707"));
  EXPECT_FALSE(choice("exact", ""));
  EXPECT_FALSE(choice("auto", ""));
  EXPECT_EQ(choice("dopri5", "")->step, 0.0);
  for (const auto& [flow, step, limit] :
       {std::array{"rk4", "0.0708", "0.0707107"}, std::array{"dopri5", "0.02494", "0.0249297"},
        std::array{"fehlberg78", "0.0592", "0.0591289"}}) {
    try {
      choice(flow, step);
      ADD_FAILURE() << flow;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(limit), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("solver.step"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace graze
