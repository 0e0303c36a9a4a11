// G1, M7 and the paper's beam: motion in time. Expected values: closed forms, stated at each test.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/detail/motion.hpp"
#include "support/reached.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::expect_reached;
using support::for_impacts;
using support::for_seconds;
using support::off;
using support::oscillator;
using support::record_run;
using support::RecordedRun;
using support::state_of;

// x'' + x = 0 with amplitude 1 + d meets the stop at 1 with v = sqrt(2 d + d^2).
void expect_shallow_contact(double depth, double speed) {
  const double amplitude = 1.0 + depth;
  const double allowed = std::max(1e-12, 4.0 * 2.2e-16 / depth);
  const System system = oscillator(1.0, 0.0, 1.0, 0.8);
  for (const State& start : {state_of({0.0}, {amplitude}), state_of({-amplitude}, {0.0})}) {
    SCOPED_TRACE(start.q[0]);
    for (const double duration : {4.0, 40.0, 1e4}) {
      const RecordedRun run = record_run(system, start, for_impacts(1, duration));
      ASSERT_EQ(run.events.size(), 1u) << "depth " << depth << ", duration " << duration;
      std::ostringstream row;
      row << "speed of a contact " << depth << " deep, relative";
      expect_reached("G1", row.str(), support::relative(run.events[0].speed, speed), allowed);
      EXPECT_LT(run.events[0].time, 4.0);
    }
  }
}

TEST(HardCases, G1ShallowContact) {
  expect_shallow_contact(1e-4, 0.014142489172702237);
  expect_shallow_contact(1e-8, 1.414213565908629e-4);
  expect_shallow_contact(1e-12, 1.4142135623734486e-6);
}

TEST(HardCases, G1ShallowMissIsNoContact) {
  for (const double depth : {1e-4, 1e-8, 1e-12}) {
    const RecordedRun run = record_run(oscillator(1.0, 0.0, 1.0, 0.8),
                                       state_of({0.0}, {1.0 - depth}), for_seconds(100.0));
    EXPECT_TRUE(run.events.empty()) << depth;
    EXPECT_EQ(run.result.totals.undecided_touches, 0) << depth;
    ASSERT_TRUE(run.result.totals.smallest_gap);
    EXPECT_NEAR(*run.result.totals.smallest_gap, depth, 1e-15);
  }
}

// A stable period-1 orbit for 1e6 forcing periods; for ten times as many where GRAZE_LONG is set,
// as tests/long.sh does.
TEST(HardCases, M7LongTime) {
  const bool lengthy = std::getenv("GRAZE_LONG") != nullptr;
  const long long periods = support::kSlowBuild ? 10'000 : lengthy ? 10'000'000 : 1'000'000;
  const System system = assemble(support::reference_scene("orbits/sdof_1_6"));
  SimulationOptions options = support::for_periods(1000);
  const State settled = simulate(system, support::rest(system), options).final;
  options.periods = periods;
  options.max_impacts = 2 * periods;
  const Simulation run = simulate(system, support::rest(system), options);
  EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd);
  expect_reached(
      "M7", "stroboscopic state after 1e6 periods",
      std::max(off(run.final.q[0], settled.q[0]), off(run.final.qdot[0], settled.qdot[0])), 1e-12);
}

// Random sequences of stick, slip and impact: nothing ever passes the stop.
void expect_clear_of_the_stop(const std::string& scene_name, int modes, const std::string& side,
                              double duration, double samples_per_period) {
  SCOPED_TRACE(scene_name + ", N = " + std::to_string(modes) + ", " + side);
  const Scene scene = support::shipped_scene(
      scene_name, {"beam.modes=" + std::to_string(modes), "stop.side=\"" + side + "\""});
  const System system = assemble(scene);
  double beyond = 0.0, pull = 0.0;
  RunListeners listeners;
  listeners.sample_rate = samples_per_period / system.period();
  listeners.sample = [&](const Sample& sample) {
    beyond = std::max(beyond, system.stops[0].row.dot(sample.state.q) - system.stops[0].gap);
    pull = std::max(pull, -sample.forces[0]);
  };
  const Simulation run =
      simulate(system, initial_state(scene, system), for_seconds(duration), listeners);
  EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
  EXPECT_NEAR(run.end_time, duration, 1e-9);
  EXPECT_GT(run.totals.impacts, 10 * static_cast<int>(duration) / 2);
  const std::string span = duration > 100.0 ? "1000 s" : "10 s";
  expect_reached("Beam", "penetration over " + span + ", N = 4 and 8, both laws and sides, m",
                 std::max(beyond, -*run.totals.smallest_gap), 1e-12);
  // The force is known to the rounding of what it balances.
  expect_reached("Beam", "pull of the stop over " + span + ", N", pull, 1e-12);
}

TEST(HardCases, BeamStaysClearOfItsStop) {
  for (const char* scene : {"01_wagg_2004", "02_wagg_momentum"})
    for (const int modes : {4, 8})
      for (const char* side : {"below", "above"}) {
        expect_clear_of_the_stop(scene, modes, side, 10.0, support::kSlowBuild ? 200.0 : 2000.0);
        if (!support::kSlowBuild) expect_clear_of_the_stop(scene, modes, side, 1000.0, 100.0);
      }
}

}  // namespace
}  // namespace graze
