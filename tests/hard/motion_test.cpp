// Z, G1, E2, E3, E5 and M7: motion in time. Expected values: closed forms, stated at each test.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/hybrid/motion.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::for_impacts;
using support::for_periods;
using support::for_seconds;
using support::oscillator;
using support::record_run;
using support::RecordedRun;
using support::state_of;

// x'' + x = 0 with amplitude 1 + d meets the stop at 1 with v = sqrt(2 d + d^2).
void expect_shallow_contact(double depth, double speed) {
  const double amplitude = 1.0 + depth;
  const double relative = std::max(1e-12, 4.0 * 2.2e-16 / depth);
  const System system = oscillator(1.0, 0.0, 1.0, 0.8);
  for (const State& start : {state_of({0.0}, {amplitude}), state_of({-amplitude}, {0.0})}) {
    SCOPED_TRACE(start.q[0]);
    for (const double duration : {4.0, 40.0, 1e4}) {
      const RecordedRun run = record_run(system, start, for_impacts(1, duration));
      ASSERT_EQ(run.events.size(), 1u) << "depth " << depth << ", duration " << duration;
      EXPECT_NEAR(run.events[0].speed / speed, 1.0, relative);
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

// a = 0 without forcing: impacts every pi/w_d for ever, at speeds that fall by
// r e^{-delta pi/w_d}; no number of them is sticking.
void expect_false_zeno(double delta, double restitution) {
  SCOPED_TRACE(delta);
  const double half_turn = std::numbers::pi / std::sqrt(1.0 - delta * delta);
  const double factor = restitution * std::exp(-delta * half_turn);
  const RecordedRun run = record_run(oscillator(1.0, delta, 0.0, restitution),
                                     state_of({0.0}, {1.0}), for_impacts(1001, 2000.0 * half_turn));
  ASSERT_EQ(run.events.size(), 1001u);
  EXPECT_EQ(run.result.outcome, RunOutcome::kEventBudget);
  EXPECT_FALSE(run.result.resting_stop);
  EXPECT_EQ(run.events[0].time, 0.0);
  EXPECT_EQ(run.events[0].speed, 1.0);
  for (std::size_t k = 1; k <= 1000; ++k) {
    const double count = static_cast<double>(k);
    // After an impact the mass swings away and back: half a turn.
    EXPECT_NEAR(run.events[k].time / (count * half_turn), 1.0, 1e-13) << k;
    const double speed = std::pow(factor, count);
    if (speed < 1e-290) break;
    EXPECT_NEAR(run.events[k].speed / speed, 1.0, 1e-13 * std::max(1.0, count / 100.0)) << k;
  }
}

TEST(HardCases, Z4FalseZeno) {
  expect_false_zeno(0.0, 0.8);
  expect_false_zeno(0.0, 0.5);
  expect_false_zeno(0.02, 0.9);
}

TEST(HardCases, E5ContactAtTheStart) {
  const System system = oscillator(1.0, 0.0, 0.5, 0.8);
  const RecordedRun approaching = record_run(system, state_of({0.5}, {0.3}), for_seconds(1e-3));
  ASSERT_EQ(approaching.events.size(), 1u);
  EXPECT_EQ(approaching.events[0].time, 0.0);
  EXPECT_EQ(approaching.events[0].speed, 0.3);
  EXPECT_EQ(approaching.result.outcome, RunOutcome::kReachedEnd);

  const RecordedRun leaving = record_run(system, state_of({0.5}, {-0.3}), for_seconds(1e-3));
  EXPECT_TRUE(leaving.events.empty());

  // At rest on the stop the spring pulls it away.
  const RecordedRun pulled = record_run(system, state_of({0.5}, {0.0}), for_seconds(3.0));
  EXPECT_TRUE(pulled.events.empty());
  EXPECT_EQ(pulled.result.outcome, RunOutcome::kReachedEnd);
  EXPECT_NEAR(pulled.result.final.q[0], 0.5 * std::cos(3.0), 1e-14);

  // A force of 1 against a spring force of .5: pushed, at rest.
  const System pushed = support::forced_oscillator(1.0, 0.0, 0.5, 0.8, 0.1, 1.0);
  const RecordedRun stuck = record_run(pushed, state_of({0.5}, {0.0}), for_seconds(1e-3));
  EXPECT_TRUE(stuck.events.empty());
  EXPECT_EQ(stuck.result.resting_stop, 0);
}

TEST(HardCases, E5StartBeyondTheStopIsAnError) {
  const std::string text =
      "[modal]\nfrequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = 0.5\nrestitution = 0.8\n"
      "[initial]\nq = [0.75]\nqdot = [0.0]\n";
  const Scene scene = parse_scene(text, "beyond.toml");
  const System system = assemble(scene);
  try {
    initial_state(scene, system);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("beyond.toml:8:"), std::string::npos) << message;
    EXPECT_NE(message.find("initial.q"), std::string::npos) << message;
    EXPECT_NE(message.find("0.25"), std::string::npos) << message;
  }
}

double energy(const System& system, const Vector& q, const Vector& qdot) {
  return 0.5 * (qdot.squaredNorm() + system.omega.cwiseProduct(q).squaredNorm());
}

// r = 1, undamped and unforced: the energy stays what it was. Unit cantilever, stop at the tip.
System elastic_beam(int modes) {
  const double b[] = {1.8751040687119611664, 4.6940911329741745764, 7.8547574382376125649,
                      10.995540734875466991, 14.137168391046470581};
  System system{Vector(modes), Vector::Zero(modes), {}, {}};
  Vector row(modes);
  for (int j = 0; j < modes; ++j) {
    system.omega[j] = b[j] * b[j];
    row[j] = j % 2 == 0 ? 2.0 : -2.0;
  }
  system.stops.push_back({row, 0.05, momentum_direction(row), 1.0});
  return system;
}

void expect_energy_kept(int modes, long long impacts, double relative) {
  const System system = elastic_beam(modes);
  State start = support::rest(system);
  start.qdot = Vector::LinSpaced(modes, 1.0, 0.4);
  SimulationOptions options = for_seconds(1e9);
  options.max_impacts = impacts;
  const Simulation run = simulate(system, start, options);
  EXPECT_EQ(run.totals.impacts, impacts);
  const double before = energy(system, start.q, start.qdot);
  EXPECT_NEAR(energy(system, run.final.q, run.final.qdot) / before, 1.0, relative);
}

TEST(HardCases, E2ElasticImpactsKeepTheEnergy) {
  expect_energy_kept(2, 1'000'000, 1e-11);
  expect_energy_kept(5, 100'000, 1e-12);
}

TEST(HardCases, E3Reversal) {
  const System system = elastic_beam(2);
  const State start = state_of({0.0, 0.0}, {1.0, 0.3});
  Motion<double> out(system, {}, start.q, start.qdot);
  double flown = 0.0;
  for (int impacts = 0; impacts < 10;) {
    const Arrival<double> arrival = out.fly(1e6);
    ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
    out.impact(arrival.stop);
    ++impacts;
    flown = out.instant().local;
  }
  // On a little into free flight, then back the same way.
  const double beyond = 0.01;
  ASSERT_EQ(out.fly(flown + beyond).kind, ArrivalKind::kTime);
  Motion<double> back(system, {}, out.q(), -out.qdot());
  int impacts = 0;
  const double end = out.instant().local;
  while (back.instant().local < end) {
    const Arrival<double> arrival = back.fly(end);
    if (arrival.kind != ArrivalKind::kContact) continue;
    back.impact(arrival.stop);
    ++impacts;
  }
  EXPECT_EQ(impacts, 10);
  EXPECT_NEAR(back.q()[0], 0.0, 1e-12);
  EXPECT_NEAR(back.q()[1], 0.0, 1e-12);
  EXPECT_NEAR(back.qdot()[0], -1.0, 1e-12);
  EXPECT_NEAR(back.qdot()[1], -0.3, 1e-12);
}

// A stable period-1 orbit for 1e6 forcing periods (the catalogue's 1e7 take ten times as long).
TEST(HardCases, M7LongTime) {
  const System system = assemble(support::reference_scene("orbits/sdof_1_6"));
  SimulationOptions options = for_periods(1000);
  const State settled = simulate(system, support::rest(system), options).final;
  options.periods = 1'000'000;
  const Simulation run = simulate(system, support::rest(system), options);
  EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd);
  EXPECT_NEAR(run.final.q[0], settled.q[0], 1e-12);
  EXPECT_NEAR(run.final.qdot[0], settled.qdot[0], 1e-12);
}

}  // namespace
}  // namespace graze
