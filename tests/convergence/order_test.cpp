// The observed order of every flow that takes steps, across located contacts: errors of impact
// times against 50 digits over steps that are halved.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/study/cost/reference_run.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

struct Case {
  StepMethod method;
  double order = 0.0, within = 0.0;
  double first = 0.0;  // step, of the longest stable one
  int halvings = 0;
};

// From where the error is that of its leading term down to rounding; Fehlberg's steps are so good
// that few halvings lie between, and on the beam too few for the part of a step that is left before
// each impact not to matter.
const std::vector<Case> kOscillator = {{StepMethod::kRk4, 4.0, 0.2, 0.1, 4},
                                       {StepMethod::kDopri5, 5.0, 0.3, 0.2, 4},
                                       {StepMethod::kFehlberg78, 8.0, 0.5, 0.25, 2}};
const std::vector<Case> kBeam = {{StepMethod::kRk4, 4.0, 0.2, 0.025, 3},
                                 {StepMethod::kDopri5, 5.0, 0.3, 0.1, 3}};

std::vector<double> impact_times(const System& system, const State& start,
                                 const std::optional<StepSetting>& steps, double duration) {
  SimulationOptions options;
  options.duration = duration;
  options.steps = steps;
  std::vector<double> times;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kImpact) times.push_back(event.time);
  };
  EXPECT_EQ(simulate(system, start, options, listeners).outcome, RunOutcome::kReachedEnd);
  return times;
}

double error_of(const std::vector<double>& times, const ReferenceRun& reference) {
  EXPECT_EQ(times.size(), reference.impacts.size());
  double error = 0.0;
  for (std::size_t i = 0; i < std::min(times.size(), reference.impacts.size()); ++i)
    error = std::max(error, std::abs(times[i] - reference.impacts[i].time));
  return error;
}

void expect_order(const Scene& scene, std::size_t impacts, const std::vector<Case>& cases) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  ReferenceOptions options;
  options.impacts = impacts;
  options.longest = 100.0 * system.period();
  const ReferenceRun reference = reference_run(system, start, options);
  ASSERT_EQ(reference.impacts.size(), impacts);
  EXPECT_LE(error_of(impact_times(system, start, {}, reference.end_time), reference), 1e-12);
  for (const Case& c : cases) {
    SCOPED_TRACE(static_cast<int>(c.method));
    StepSetting setting;
    setting.method = c.method;
    setting.longest = longest_stable_step(system, c.method);
    setting.step = c.first * setting.longest;
    std::vector<double> errors;
    for (int i = 0; i <= c.halvings; ++i, setting.step /= 2.0)
      errors.push_back(
          error_of(impact_times(system, start, setting, reference.end_time), reference));
    // Over all halvings: where the zero lies within its step changes the error from one to the
    // next.
    const double order = std::log2(errors.front() / errors.back()) / c.halvings;
    EXPECT_NEAR(order, c.order, c.within) << errors.front() << " .. " << errors.back();
  }
}

TEST(Order, HoldsAcrossImpactsOfAnOscillator) {
  expect_order(support::shipped_scene("04_impact_oscillator"), 5, kOscillator);
}

TEST(Order, HoldsAcrossImpactsOfABeam) {
  expect_order(support::shipped_scene("02_wagg_momentum", {"beam.modes=2", "stop.gap=5e-3"}), 4,
               kBeam);
}

// A method whose steps are told by their error: what it errs falls with its tolerance.
TEST(Order, ErrorsFollowTheTolerance) {
  const Scene scene = support::shipped_scene("04_impact_oscillator");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  ReferenceOptions options;
  options.impacts = 6;  // the next is over in 0.03 s, which a step may miss
  options.longest = 100.0 * system.period();
  const ReferenceRun reference = reference_run(system, start, options);
  for (const StepMethod method : {StepMethod::kDopri5, StepMethod::kFehlberg78}) {
    StepSetting setting;
    setting.method = method;
    setting.longest = longest_stable_step(system, method);
    setting.speed = 1.0;
    std::vector<double> errors;
    for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
      setting.tolerance = tolerance;
      errors.push_back(
          error_of(impact_times(system, start, setting, reference.end_time), reference));
      // A few steps' errors add up over six impacts.
      EXPECT_LE(errors.back(), 1e3 * tolerance);
    }
    EXPECT_LE(errors[1], 1e-2 * errors[0]);
    EXPECT_LE(errors[2], 1e-2 * errors[1]);
  }
}

// The displacement at the end of a run without stops, and what the closed form says.
void expect_end(const System& system, const State& start, double seconds, double meant,
                double size) {
  for (const StepMethod method : {StepMethod::kDopri5, StepMethod::kFehlberg78})
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      SimulationOptions options;
      options.duration = seconds;
      options.steps = stable_steps(system, start, method);
      options.steps->tolerance = tolerance;
      const Simulation run = simulate(system, start, options);
      EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd);
      // The errors of some hundred steps add up.
      EXPECT_NEAR(run.final.q[0], meant, 1e3 * tolerance * size)
          << static_cast<int>(method) << " " << tolerance;
    }
}

// x'' = f cos(W t): x = v t + f (1 - cos W t)/W^2. Nothing in the structure answers, so a method
// that looks only at the ends of its steps sees no force at all.
TEST(Order, StepsSeeAForceOnAFreeMass) {
  System system = support::forced_oscillator(0.0, 0.0, 1.0, 0.8, 0.9, 0.5);
  system.stops.clear();
  const double v = 1e-3, seconds = 100.0;
  const double x = v * seconds + 0.5 * (1.0 - std::cos(0.9 * seconds)) / 0.81;
  // An error of the velocity goes on for the rest of the time.
  expect_end(system, support::state_of({0.0}, {v}), seconds, x, seconds);
}

// Much quicker than the structure: x = f (cos W t - cos w t)/(w^2 - W^2).
TEST(Order, StepsSeeAQuickForce) {
  System system = support::forced_oscillator(1.0, 0.0, 1.0, 0.8, 1000.0, 1000.0);
  system.stops.clear();
  const double seconds = 10.0;
  const double x = 1000.0 * (std::cos(1000.0 * seconds) - std::cos(seconds)) / (1.0 - 1e6);
  expect_end(system, support::rest(system), seconds, x, 1.0);
}

}  // namespace
}  // namespace graze
