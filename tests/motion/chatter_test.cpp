// Chatter: what it costs, when it is summed and when not, and with restitution that depends on the
// speed.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/detail/motion.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::for_seconds;
using support::record_run;
using support::RecordedRun;
using support::state_of;

// Evaluations of the gap per flight through the chatter of the paper's beam, followed far below
// the closure speed.
TEST(Chatter, CostPerImpactDoesNotGrow) {
  for (const char* name : {"01_wagg_2004", "02_wagg_momentum"}) {
    for (const int modes : {1, 4, 8}) {
      SCOPED_TRACE(testing::Message() << name << ", N = " << modes);
      const Scene scene = support::shipped_scene(
          name, {"beam.modes=" + std::to_string(modes), "stop.restitution=0.5"});
      const System system = assemble(scene);
      const State start = initial_state(scene, system);
      Motion<double> motion(system, {}, start.q, start.qdot);
      // Speeds of a chatter fall over ten decades; its flights in each decade, by their start,
      // which come back slower. One that comes back faster has left the chatter.
      std::map<int, long long> most;
      long long ordinary = 0;
      double fastest = 0.0, before = 0.0;
      while (motion.instant().period < 40) {
        const Arrival<double> arrival = motion.fly(motion.flow().period());
        const bool faster = arrival.kind != ArrivalKind::kContact || arrival.speed >= before;
        if (before > 0.0 && arrival.flight > 0.0 && faster)
          ordinary = std::max(ordinary, arrival.evaluations);
        if (before > 0.0 && arrival.flight > 0.0 && !faster) {
          long long& decade = most[static_cast<int>(std::floor(std::log10(before / fastest)))];
          decade = std::max(decade, arrival.evaluations);
        }
        before = 0.0;
        if (arrival.kind != ArrivalKind::kContact) continue;
        before = arrival.speed;
        fastest = std::max(fastest, before);
        motion.impact();
      }
      if (modes == 1) continue;  // which does not chatter at this frequency
      ASSERT_LT(most.begin()->first, -8);
      for (const auto& [decade, evaluations] : most)
        if (decade >= -4) ordinary = std::max(ordinary, evaluations);
      for (const auto& [decade, evaluations] : most) {
        if (decade >= -4) continue;
        EXPECT_LE(evaluations, ordinary) << "speeds of 1e" << decade;
        EXPECT_LE(evaluations, 25) << "speeds of 1e" << decade;
      }
    }
  }
}

// x'' + x = cos(W t), x <= s: pushed from t = 0 until it is released.
System pushed_oscillator(double stop, const Restitution& restitution) {
  System system = support::forced_oscillator(1.0, 0.0, stop, 0.0, 0.3, 1.0);
  system.stops[0].impact().restitution = restitution;
  return system;
}

TEST(Chatter, ThatLosesNothingAtLowSpeedNeverCompletes) {
  // A ball with r(v) = 1 - v/2: the speeds fall like 2/k, and the flights 4/(g k) have no finite
  // sum.
  System ball = support::oscillator(0.0, 0.0, 1.0, 0.0);
  ball.modal().load = Vector::Constant(1, 1.0);
  ball.stops[0].impact().restitution = Restitution(std::vector<double>{1.0, 0.5});
  SimulationOptions options = for_seconds(100.0);
  options.max_impacts = 20'000;
  const RecordedRun run = record_run(ball, support::rest(ball), options);
  EXPECT_EQ(run.result.outcome, RunOutcome::kEventBudget);
  EXPECT_EQ(run.result.totals.chatters, 0);
  EXPECT_TRUE(run.result.stuck.empty());
  EXPECT_NE(run.result.message.find("20000 impacts"), std::string::npos) << run.result.message;
}

TEST(Chatter, OfARestitutionThatFallsWithTheSpeedCompletes) {
  // Near rest r = a0: the ratio of successive speeds tends to it.
  const System system = pushed_oscillator(0.1, Restitution(std::vector<double>{0.6, 0.3}));
  const RecordedRun run = record_run(system, state_of({0.1}, {-0.2}), for_seconds(3.0));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
  EXPECT_EQ(run.result.stuck, std::vector<int>{0});
  std::vector<double> speeds;
  for (const Event& event : run.events)
    if (event.kind == EventKind::kImpact) speeds.push_back(event.speed);
  ASSERT_GT(speeds.size(), 10u);
  for (std::size_t k = speeds.size() - 4; k + 1 < speeds.size(); ++k)
    EXPECT_NEAR(speeds[k + 1] / speeds[k], 0.6, 1e-4);
  // Each rebound obeys v+ = -r(v) v: the free flight between impacts nearly keeps the speed.
  EXPECT_EQ(run.result.totals.clamped_restitutions, 0);
}

TEST(Chatter, ClampedRestitutionsAreCounted) {
  System system = support::oscillator(1.0, 0.0, 0.5, 0.0);
  system.stops[0].impact().restitution = Restitution(std::vector<double>{0.9, 1.0});
  const RecordedRun run = record_run(system, state_of({0.5}, {2.0}), for_seconds(1.0));
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_EQ(run.result.totals.clamped_restitutions, 1);  // .9 - 2 < 0
  EXPECT_NEAR(run.result.final.q[0], 0.5 * std::cos(1.0), 1e-15);
}

TEST(Chatter, IsReportedAtItsLastImpactAndSticksAtTheAccumulation) {
  System ball = support::oscillator(0.0, 0.0, 1.0, 0.5);
  ball.modal().load = Vector::Constant(1, 9.81);
  SimulationOptions options = for_seconds(3.0);
  options.closure_speed = 0.1;
  const RecordedRun run = record_run(ball, support::rest(ball), options);
  // Speeds sqrt(2 g) 2^-k: 4.43, 2.21, 1.1, .55, .28, .14, .069.
  ASSERT_EQ(run.events.size(), 9u);
  EXPECT_EQ(run.events[7].kind, EventKind::kChatter);
  EXPECT_EQ(run.events[7].impacts, 7);
  EXPECT_EQ(run.events[7].time, run.events[6].time);
  EXPECT_EQ(run.events[7].closure_speed, 0.1);
  EXPECT_EQ(run.events[8].kind, EventKind::kStick);
  EXPECT_EQ(run.events[8].force, 9.81);
  // With a constant push the sum is exact, whatever the closure speed.
  EXPECT_NEAR(run.events[8].time, std::sqrt(2.0 / 9.81) * 3.0, 1e-15);
  EXPECT_NEAR(run.result.totals.stuck_time, 3.0 - run.events[8].time, 1e-14);
  EXPECT_NEAR(run.result.totals.energy_lost, 9.81, 1e-14);
}

}  // namespace
}  // namespace graze
