// Starts at rest on a stop at which the push vanishes together with its rate: what the push does
// next, quadratically, decides.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

support::RecordedRun run_of(const std::vector<std::string>& settings, double periods) {
  const Scene scene = support::shipped_scene("04_impact_oscillator", settings);
  const System system = assemble(scene);
  return support::record_run(system, initial_state(scene, system),
                             support::for_seconds(periods * system.period()));
}

// x'' + x = F cos(3t/2) from x = F at rest: x = F (9/5 cos t - 4/5 cos(3t/2)), which leaves F as
// -F (3/2)^2 t^4/4!.
TEST(BalancedStart, LeavesTheStopAtOnce) {
  for (const double force : {0.5, 1.0, 30.0}) {
    const std::string value = std::to_string(force);
    const support::RecordedRun run =
        run_of({"modal.damping_ratios=[0.0]", "forcing.frequency=1.5", "stop.gap=" + value,
                "forcing.amplitude=" + value, "initial.q=[" + value + "]"},
               1.4);
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    double low = M_PI, high = 2.0 * M_PI;
    const auto beyond = [](double t) { return 1.8 * std::cos(t) - 0.8 * std::cos(1.5 * t) > 1.0; };
    ASSERT_TRUE(!beyond(low) && beyond(high));
    while (0.5 * (low + high) > low && 0.5 * (low + high) < high)
      (beyond(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    ASSERT_FALSE(run.events.empty());
    EXPECT_EQ(run.events.front().kind, EventKind::kImpact);
    EXPECT_NEAR(run.events.front().time, high, 1e-12);
    EXPECT_NEAR(run.events.front().speed,
                force * (-1.8 * std::sin(high) + 1.2 * std::sin(1.5 * high)), 1e-11 * force);
  }
}

TEST(BalancedStart, LeavesWithDampingToo) {
  const support::RecordedRun run = run_of(
      {"forcing.frequency=1.6", "stop.gap=0.5", "forcing.amplitude=0.5", "initial.q=[0.5]"}, 50.0);
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  ASSERT_FALSE(run.events.empty());
  EXPECT_EQ(run.events.front().kind, EventKind::kImpact);
  EXPECT_GT(run.events.front().time, 1.0);
}

// Pressed by F (1 - cos(Wt)) >= 0, which touches zero every period and never pulls.
TEST(BalancedStart, StaysWhereThePushTouchesZero) {
  const support::RecordedRun run =
      run_of({"forcing.frequency=1.5", "forcing.phase=3.141592653589793", "stop.gap=-1",
              "forcing.amplitude=1", "initial.q=[-1.0]"},
             3.0);
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  for (const Event& event : run.events) EXPECT_NE(event.kind, EventKind::kRelease) << event.time;
  EXPECT_NEAR(run.result.totals.stuck_time, run.result.end_time, 1e-12);
}

}  // namespace
}  // namespace graze
