// The flow that "auto" takes, held to the reference on every shipped scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/flow_cost.hpp"
#include "graze/study/step_choice.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(GRAZE_SOURCE_DIR) / "data/scenes"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  return paths;
}

// Every setting that meets the tolerance takes at least as many evaluations: of the whole
// right-hand side, where the exact flow evaluates a gap.
TEST(FlowDecision, MeetsTheToleranceOfEveryShippedSceneForTheLeast) {
  int scenes = 0;
  for (const std::string& path : shipped_scenes()) {
    SCOPED_TRACE(path);
    const Scene scene = read_scene(path);
    const System system = assemble(scene);
    // Costs are compared at rigid stops.
    if (std::any_of(system.stops.begin(), system.stops.end(),
                    [](const RigidStop& stop) { return stop.spring.has_value(); }))
      continue;
    const State start = initial_state(scene, system);
    FlowCostOptions options;
    options.impacts = 20;
    options.longest = system.forcing ? 40.0 * system.period() : 10.0;
    options.tolerance = scene.solver.tolerance;
    options.row_seconds = 0.05;
    options.speed = modal_speed(system, start);
    options.closure_speed = default_closure_speed(system, start, scene.solver.tolerance);
    const FlowCosts costs = flow_costs(system, start, options);
    const std::string taken = flow_name(flow_decision(scene).flow);
    const FlowCost* own = nullptr;
    for (const FlowCost& row : costs.rows)
      if (row.flow == taken) own = &row;
    ASSERT_NE(own, nullptr);
    EXPECT_LE(own->compared.error.value_or(1.0), costs.allowed);
    for (const FlowCost& row : costs.rows)
      if (row.compared.error && *row.compared.error <= costs.allowed) {
        EXPECT_LE(own->evaluations_per_period, row.evaluations_per_period)
            << row.flow << " " << row.setting;
      }
    ++scenes;
  }
  EXPECT_EQ(scenes, 10);
}

TEST(FlowDecision, IsWhatTheSceneAsksFor) {
  Scene scene = support::shipped_scene("02_wagg_momentum");
  EXPECT_EQ(flow_decision(scene).flow, FlowChoice::kExact);
  EXPECT_NE(flow_decision(scene).reason.find("1e-10"), std::string::npos);
  for (const FlowChoice flow : {FlowChoice::kExact, FlowChoice::kRk4, FlowChoice::kDopri5}) {
    scene.solver.flow = flow;
    EXPECT_EQ(flow_decision(scene).flow, flow);
  }
}

}  // namespace
}  // namespace graze
