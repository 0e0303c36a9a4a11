// A run whose own balance or gap shows that it went wrong says so.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/record/records.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// A sound run of a forced oscillator that reached its end after about 100 periods and 100 impacts.
Simulation sound_run() {
  Simulation run;
  run.end_time = 600.0;
  run.final = support::state_of({0.0}, {0.0});
  run.totals.impacts = 100;
  run.totals.energy_lost = 1.0;
  run.totals.smallest_gap = 0.0;
  run.energy = EnergyBalance{};
  run.energy->start = 1.0;
  run.energy->impacts = -1.0;
  return run;
}

const System& forced_system() {
  static const System system = support::forced_oscillator(1.0, 0.1, 0.5, 0.8, 1.0, 1.0);
  return system;
}

TEST(SimulationWarnings, ASoundRunHasNone) {
  EXPECT_TRUE(simulation_warnings(forced_system(), sound_run()).empty());
  Simulation rounded = sound_run();
  rounded.energy->work.forcing = 1e-12;
  rounded.totals.penetration = 1e-15;
  rounded.totals.smallest_gap = -5e-3;  // of a compressed spring
  EXPECT_TRUE(simulation_warnings(forced_system(), rounded).empty());
}

TEST(SimulationWarnings, ABalanceThatDoesNotCloseIsSaid) {
  Simulation run = sound_run();
  run.energy->work.load = 4e-3;
  const std::vector<std::string> warnings = simulation_warnings(forced_system(), run);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("does not close"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("0.004 J"), std::string::npos) << warnings[0];
}

TEST(SimulationWarnings, APenetrationIsSaid) {
  Simulation run = sound_run();
  run.totals.penetration = 2e-3;
  const std::vector<std::string> warnings = simulation_warnings(forced_system(), run);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("penetrated by 0.002 m"), std::string::npos) << warnings[0];
}

// Ten seconds of a beam on a hub, of some ten thousand steps: what they err by is none of a
// warning, a hundred times as much is.
TEST(SimulationWarnings, OfAStructureThatTurns) {
  Scene scene = support::shipped_scene("17_yigit_lee_wang_1");
  scene.stops.clear();
  scene.hub->torque.reset();
  scene.initial = Initial{{1e-3, 1e-3, 1e-4}, {0.0, 0.0, 0.0}, 0.0, 5.0};
  const System system = assemble(scene);
  SimulationOptions options;
  options.duration = 10.0;
  options.energy = true;
  Simulation run = simulate(system, initial_state(scene, system), options, {});
  ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd);
  EXPECT_LT(std::abs(run.energy->defect()), 1e-9 * run.energy->size());
  EXPECT_TRUE(simulation_warnings(system, run).empty());
  run.energy->work.load += 1e-7 * run.energy->size();
  EXPECT_EQ(simulation_warnings(system, run).size(), 1u);
}

}  // namespace
}  // namespace graze
