// Every flow that takes steps gets every shipped scene to its end, through chatter and rest.
#include <gtest/gtest.h>

#include <chrono>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// A motion that does not get on is told from a slow one by what it counts, not by the clock: that
// only ends a test that would otherwise never do.
constexpr std::chrono::seconds kEnd{120};

void expect_end(const Scene& scene, StepMethod method, double tolerance, double oscillations) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.duration = oscillations * (system.forcing() ? system.period() : 1.0);
  options.steps = stable_steps(system, start, method);
  options.steps->tolerance = tolerance;
  if (method == StepMethod::kRk4) options.steps->step = 0.5 * options.steps->longest;
  options.closure_speed = default_closure_speed(system, start, tolerance);
  options.max_impacts = 20000;
  options.stop.deadline = std::chrono::steady_clock::now() + kEnd;
  const Simulation run = simulate(system, start, options);
  EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
  EXPECT_LT(run.totals.undecided_touches, 10000);
}

TEST(StepRuns, GetToTheirEnd) {
  for (const char* name :
       {"01_wagg_2004", "02_wagg_momentum", "03_wagg_fig4", "04_impact_oscillator",
        "05_wagg_one_mode", "06_bouncing_ball", "07_two_stops", "08_preloaded_oscillator",
        "09_soft_stop_two_modes", "10_two_supports"})
    for (const StepMethod method :
         {StepMethod::kRk4, StepMethod::kDopri5, StepMethod::kFehlberg78}) {
      SCOPED_TRACE(std::string(name) + ", method " + std::to_string(static_cast<int>(method)));
      expect_end(support::shipped_scene(name), method, 1e-9, 4.0);
    }
}

// Settling on a stop, by flights whose height is below the rounding of the gap.
TEST(StepRuns, ComeToRestWithinTheRoundingOfTheGap) {
  expect_end(support::shipped_scene("09_soft_stop_two_modes"), StepMethod::kFehlberg78, 1e-12,
             10.0);
  for (const double tolerance : {1e-11, 1e-12, 1e-13})
    expect_end(support::shipped_scene("05_wagg_one_mode", {"beam.modes=3", "stop.position=0.1"}),
               StepMethod::kFehlberg78, tolerance, 6.0);
}

}  // namespace
}  // namespace graze
