// Motions integrated step by step: the same events as the exact flow's, found by signs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::record_run;
using support::RecordedRun;
using support::state_of;

constexpr StepMethod kMethods[] = {StepMethod::kRk4, StepMethod::kDopri5, StepMethod::kFehlberg78};

StepSetting precise(const System& system, StepMethod method) {
  StepSetting setting;
  setting.method = method;
  setting.longest = longest_stable_step(system, method);
  setting.speed = 1.0;
  setting.tolerance = 1e-13;
  if (method == StepMethod::kRk4) setting.step = 1e-3 * setting.longest;
  return setting;
}

SimulationOptions stepping(const StepSetting& setting, long long periods) {
  SimulationOptions options;
  options.periods = periods;
  options.steps = setting;
  return options;
}

std::optional<double> time_of(const RecordedRun& run, EventKind kind) {
  for (const Event& event : run.events)
    if (event.kind == kind) return event.time;
  return {};
}

// The pushed oscillator of the catalogue's Z2: x'' + x = cos(0.3 t), x <= 0.1, r = 0.8. It rests on
// the stop, is released at acos(0.1)/0.3 and comes back; the chatter then completes.
TEST(StepFlow, ReleasesHitsChattersAndSticks) {
  const System system = support::forced_oscillator(1.0, 0.0, 0.1, 0.8, 0.3, 1.0);
  for (const StepMethod method : kMethods) {
    SCOPED_TRACE(static_cast<int>(method));
    const RecordedRun run =
        record_run(system, state_of({0.1}, {0.0}), stepping(precise(system, method), 2));
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    EXPECT_NEAR(time_of(run, EventKind::kRelease).value_or(0.0), 4.9020963521111227, 1e-10);
    EXPECT_NEAR(time_of(run, EventKind::kImpact).value_or(0.0), 16.723521925366774, 1e-8);
    EXPECT_NEAR(time_of(run, EventKind::kStick).value_or(0.0), 24.562829155337235, 1e-6);
    EXPECT_GT(run.result.evaluations, 1000);
  }
}

// Held by an oblique law the modes do not decouple: those steps are taken on a dense system.
TEST(StepFlow, FollowsCoupledModesOnAStop) {
  const Scene scene = support::shipped_scene("09_soft_stop_two_modes");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions exact;
  exact.periods = 3;
  const RecordedRun expected = record_run(system, start, exact);
  ASSERT_TRUE(time_of(expected, EventKind::kStick));
  for (const StepMethod method : kMethods) {
    SCOPED_TRACE(static_cast<int>(method));
    const RecordedRun run = record_run(system, start, stepping(precise(system, method), 3));
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    EXPECT_EQ(run.events.size(), expected.events.size());
    EXPECT_LE((run.result.final.q - expected.result.final.q).norm(),
              1e-7 * expected.result.final.q.norm());
    EXPECT_NEAR(run.result.totals.stuck_time, expected.result.totals.stuck_time, 1e-7);
  }
}

// A motion that is cut and goes on is the same to the last bit as one that was not.
TEST(StepFlow, CutMotionsGoOnAsIfTheyHadNotBeenCut) {
  const Scene scene = support::shipped_scene("02_wagg_momentum", {"stop.gap=5e-3"});
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  for (const StepMethod method : kMethods) {
    SCOPED_TRACE(static_cast<int>(method));
    StepSetting setting = precise(system, method);
    setting.tolerance = 1e-8;
    if (setting.step > 0.0) setting.step = 0.02 * setting.longest;
    const SimulationOptions whole = stepping(setting, 6);
    SimulationOptions part = whole;
    part.duration = 0.613;  // within a period, an arc and a step
    const Simulation before = simulate(system, start, part);
    const Simulation at_once = simulate(system, start, whole);
    const Simulation resumed = resume(system, before.state, whole);
    EXPECT_EQ(resumed.final.q, at_once.final.q);
    EXPECT_EQ(resumed.final.qdot, at_once.final.qdot);
    EXPECT_EQ(resumed.totals.impacts, at_once.totals.impacts);
  }
}

// Samples come from the steps, not from the exact flow.
TEST(StepFlow, SamplesLieOnTheSteppedMotion) {
  const System system = support::forced_oscillator(1.0, 0.01, 10.0, 0.8, 0.7, 1.0);
  StepSetting setting = precise(system, StepMethod::kRk4);
  setting.step = 0.4;  // coarse: errors are seen
  SimulationOptions options = stepping(setting, 3);
  std::vector<Sample> samples;
  RunListeners listeners;
  listeners.sample = [&](const Sample& sample) { samples.push_back(sample); };
  listeners.sample_rate = 1.0 / system.period();
  const Simulation run = simulate(system, support::rest(system), options, listeners);
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_EQ(samples.back().state.q, run.final.q);
  options.steps.reset();
  const Simulation exact = simulate(system, support::rest(system), options);
  const double error = (exact.final.q - run.final.q).norm();
  EXPECT_GT(error, 1e-5);
  EXPECT_LT(error, 1e-1);
}

// What these flows cannot see: the motion dips beyond the stop and back within one step.
TEST(StepFlow, AContactWithinOneStepIsMissed) {
  // x = 1.0001 cos t about its peak at t = 2 pi, stop at 1: beyond it for 0.028 s.
  const System system = support::oscillator(1.0, 0.0, 1.0, 0.8);
  StepSetting setting = precise(system, StepMethod::kRk4);
  setting.step = std::numbers::pi / 4.5;  // steps end half a step to either side of the peak
  SimulationOptions options;
  options.duration = 7.0;
  const State start = state_of({0.0}, {-1.0001});  // x = -1.0001 sin t, at its peak at 3 pi/2
  EXPECT_EQ(simulate(system, start, options).totals.impacts, 1);
  options.steps = setting;
  EXPECT_EQ(simulate(system, start, options).totals.impacts, 0);
}

TEST(StepFlow, LongestStableStepsAreThoseOfTheMethods) {
  const System light = support::oscillator(50.0, 0.1, 1.0, 0.8);
  EXPECT_NEAR(longest_stable_step(light, StepMethod::kRk4), 2.0 * std::sqrt(2.0) / 50.0, 1e-15);
  EXPECT_NEAR(longest_stable_step(light, StepMethod::kDopri5), 0.997 / 50.0, 1e-5);
  // Above critical damping the quicker rate counts: delta + sqrt(delta^2 - w^2) = 18, w = 6.
  const System heavy = support::oscillator(6.0, 10.0, 1.0, 0.8);
  EXPECT_LE(longest_stable_step(heavy, StepMethod::kRk4), 2.7853 / 18.0);  // real axis
  EXPECT_GE(longest_stable_step(heavy, StepMethod::kRk4), 2.6 / 18.0);
}

// At the limit named a step damps what it should not, a little beyond it the motion explodes.
TEST(StepFlow, StepsBeyondTheLimitExplode) {
  const System system = support::oscillator(50.0, 0.0, 1e9, 0.8);
  for (const StepMethod method : kMethods) {
    StepSetting setting = precise(system, method);
    SimulationOptions options;
    options.duration = 2000.0;
    const State start = state_of({1e-3}, {0.0});
    const auto size_after = [&](double part) {
      setting.step = part * setting.longest;
      options.steps = setting;
      const Simulation run = simulate(system, start, options);
      return run.outcome == RunOutcome::kReachedEnd ? run.final.q.norm() : 1e300;
    };
    EXPECT_LE(size_after(0.99), 1.1e-3);
    EXPECT_GE(size_after(1.1), 1e-2) << static_cast<int>(method);
  }
}

}  // namespace
}  // namespace graze
