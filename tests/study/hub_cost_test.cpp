// What accuracy costs on a hub: the reference of two methods, and flows against it.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/study/cost/detail/stepped_reference.hpp"
#include "graze/study/cost/flow_cost.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "support/hub_scene.hpp"

namespace graze {
namespace {

FlowCosts costs_of(const Scene& scene, double longest) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  FlowCostOptions options;
  options.impacts = 3;
  options.longest = longest;
  options.tolerance = 1e-8;
  options.row_seconds = 0.02;
  options.speed = modal_speed(system, start);
  options.closure_speed = default_closure_speed(system, start);
  return flow_costs(system, start, options);
}

// Classical Runge-Kutta gains 4^4 from one rung, a quarter of the step, to the next.
TEST(HubCost, RungeKuttaHasItsOrder) {
  Scene scene = support::strip_on_hub(2);
  scene.gravity = Gravity{9.81};
  scene.initial = Initial{{0.01, 0.001}, {0.0, 0.0}, 0.3, 4.0};
  const FlowCosts costs = costs_of(scene, 0.2);
  EXPECT_TRUE(costs.turns);
  EXPECT_EQ(costs.reference_message, "");
  ASSERT_EQ(costs.rows.front().flow, "bulirsch-stoer");
  ASSERT_TRUE(costs.rows.front().compared.error);
  EXPECT_LT(*costs.rows.front().compared.error, 1e-11);
  std::vector<double> errors;
  for (const FlowCost& row : costs.rows)
    if (row.flow == "rk4" && row.compared.error && *row.compared.error < 1e-4 &&
        *row.compared.error > 1e-9)
      errors.push_back(*row.compared.error);
  ASSERT_GE(errors.size(), 2u);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log(errors[i - 1] / errors[i]) / std::log(4.0), 4.0, 0.3);
}

TEST(HubCost, ImpactsOfTwoMethodsAgree) {
  Scene scene = support::strip_on_hub(3);
  scene.hub->torque = TorquePulse{1.0, 0.05};
  scene.stops = {support::stop_at(0.45, 0.05, 0.5)};
  const System system = assemble(scene);
  const ReferenceRun reference =
      stepped_reference(system, initial_state(scene, system), {3, 1e-4, 1.0, {}});
  EXPECT_EQ(reference.impacts.size(), 3u);
  EXPECT_EQ(reference.message, "");
  const FlowCosts costs = costs_of(scene, 1.0);
  EXPECT_EQ(costs.impacts, 3u);
  EXPECT_TRUE(costs.rows.front().compared.impacts_agree);
  EXPECT_LE(*costs.rows.front().compared.error, kVouchedTime);
}

}  // namespace
}  // namespace graze
