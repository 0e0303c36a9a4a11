// A ball on a spring too soft to matter bounces as on none; under a slow force as under a constant
// one.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/motion/simulation.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::record_run;
using support::RecordedRun;

constexpr double kGravity = 9.81, kRestitution = 0.8;

System soft_ball(double omega, double delta) {
  System system = support::oscillator(omega, delta, 1.0, kRestitution);
  system.modal().load = Vector::Constant(1, kGravity);
  return system;
}

SimulationOptions bookkeeping(double duration) {
  SimulationOptions options = support::for_seconds(duration);
  options.energy = true;
  options.closure_speed = 1e-6;
  return options;
}

// Fallen from rest to the stop at distance 1: sin(w t/2) = w/sqrt(2 g), v^2 = 2 g - w^2. A bounce
// at speed u comes back with u after tan(w t/2) = w u/(g - w^2).
struct ExactBounce {
  double time, speed;
};
std::vector<ExactBounce> exact_bounces(double omega, std::size_t count) {
  const auto over = [&](double angle, double small) {
    return omega > 0.0 ? 2.0 * angle / omega : small;
  };
  double time = over(std::asin(omega / std::sqrt(2.0 * kGravity)), std::sqrt(2.0 / kGravity));
  double speed = std::sqrt(2.0 * kGravity - omega * omega);
  std::vector<ExactBounce> bounces;
  while (bounces.size() < count) {
    bounces.push_back({time, speed});
    speed *= kRestitution;
    const double push = kGravity - omega * omega;
    time += over(std::atan(omega * speed / push), 2.0 * speed / push);
  }
  return bounces;
}

TEST(SoftBall, BouncesAsInClosedForm) {
  for (int k = 0; k <= 12; ++k) {
    const double omega = k == 0 ? 0.0 : std::pow(10.0, -k);
    SCOPED_TRACE(omega);
    const RecordedRun run =
        record_run(soft_ball(omega, 0.0), support::state_of({0.0}, {0.0}), bookkeeping(3.9));
    ASSERT_GE(run.events.size(), 10u);
    const std::vector<ExactBounce> exact = exact_bounces(omega, run.events.size());
    const std::vector<ExactBounce> free = exact_bounces(0.0, run.events.size());
    for (std::size_t i = 0; i < run.events.size(); ++i) {
      const Event& event = run.events[i];
      EXPECT_NEAR(event.time, exact[i].time, 1e-13 * exact[i].time) << i;
      EXPECT_NEAR(event.speed, exact[i].speed, 1e-13 * exact[0].speed) << i;
      const double turned = omega * event.time;
      EXPECT_NEAR(event.time, free[i].time, (turned * turned + 1e-13) * free[i].time) << i;
    }
  }
}

void expect_closed_balance(const System& system, double duration) {
  const RecordedRun run =
      record_run(system, support::state_of({0.0}, {0.0}), bookkeeping(duration));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_GT(run.result.totals.impacts, 0);
  EXPECT_GE(*run.result.totals.smallest_gap, -1e-12);
  EXPECT_LE(std::abs(run.result.energy->defect()), 1e-10 * run.result.energy->size());
  const double gap = system.stops[0].gap - run.result.final.q[0];
  EXPECT_GE(gap, -1e-12);
}

TEST(SoftBall, KeepsItsGapAndItsEnergyBalance) {
  for (int k = 1; k <= 12; ++k) {
    const double omega = std::pow(10.0, -k);
    for (const double delta : {0.0, 0.1 * omega, omega, 3.0 * omega, 0.3, 1e3}) {
      SCOPED_TRACE(testing::Message() << "omega " << omega << ", delta " << delta);
      expect_closed_balance(soft_ball(omega, delta), delta > 1.0 ? 1e3 : 10.0);
    }
  }
}

// From 1 m before the stop, wherever that is; chatters are closed at the default speed, so that the
// ten bounces must not be taken for the tail of one.
void expect_bounces_under_slow_force(double frequency, double gap) {
  const System system =
      support::forced_oscillator(0.0, 0.0, gap, kRestitution, frequency, kGravity);
  SimulationOptions options = support::for_seconds(3.9);
  options.energy = true;
  const RecordedRun run = record_run(system, support::state_of({gap - 1.0}, {0.0}), options);
  ASSERT_GE(run.events.size(), 10u);
  // q = g (1 - cos W t)/W^2, as of a mode at w = W under a constant load.
  const double first = 2.0 / frequency * std::asin(frequency / std::sqrt(2.0 * kGravity));
  const double speed = kGravity / frequency * std::sin(frequency * first);
  EXPECT_NEAR(run.events[0].time, first, 1e-13 * first);
  EXPECT_NEAR(run.events[0].speed, speed, 1e-13 * speed);
  EXPECT_GE(*run.result.totals.smallest_gap, -1e-12);
  EXPECT_LE(std::abs(run.result.energy->defect()), 1e-10 * run.result.energy->size());
  const std::vector<ExactBounce> free = exact_bounces(0.0, 10);
  const double turned = frequency * free[9].time;
  EXPECT_NEAR(run.events[9].time, free[9].time, (turned * turned + 1e-12) * free[9].time);
  EXPECT_EQ(run.events[9].kind, EventKind::kImpact);
}

TEST(SoftBall, UnderASlowForceAsUnderAConstantOne) {
  for (int k = 1; k <= 9; ++k)
    for (const double gap : {1.0, 0.0, 1e-9, -1.0}) {
      SCOPED_TRACE(testing::Message() << "frequency 1e-" << k << ", gap " << gap);
      expect_bounces_under_slow_force(std::pow(10.0, -k), gap);
    }
}

// Heavily damped under a load and a force that is slow against it: the balance is kept in closed
// form, however many times the quickest rate goes into a flight.
TEST(SoftBall, EnergyBalanceOfAHeavilyDampedMassUnderASlowForce) {
  System system = support::forced_oscillator(0.0, 5e3, 1.0, kRestitution, 1e-3, 1.0);
  system.modal().load = Vector::Constant(1, kGravity);
  expect_closed_balance(system, 1e4);
}

}  // namespace
}  // namespace graze
