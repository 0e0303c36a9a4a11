// Rigid stops that are touched at rest beside springs: which of them hold the structure and which
// are left is decided by the lowest power of time that does not vanish, of the contact force or of
// the gap, whole or not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/motion/simulation.hpp"
#include "support/mixed_chain_reference.hpp"

namespace graze {
namespace {

Vector between(Eigen::Index bodies, Eigen::Index i) {
  Vector row = Vector::Zero(bodies);
  row[i] = 1.0;
  row[i + 1] = -1.0;
  return row;
}

Stop rigid(Eigen::Index bodies, Eigen::Index i, double restitution) {
  const Vector row = between(bodies, i);
  return {row, 0.0, ImpactLaw{momentum_direction(row), restitution}};
}

Stop spring(Eigen::Index bodies, Eigen::Index i, double stiffness, double exponent) {
  return {between(bodies, i), 0.0, ContactForce{stiffness, exponent, ContactDamping::kNone}};
}

System chain(Eigen::Index bodies, std::vector<Stop> stops) {
  return {Vector::Zero(bodies), NaturalModes{Vector::Zero(bodies)}, std::move(stops)};
}

State thrown(Eigen::Index bodies, Eigen::Index body, double speed) {
  State start{Vector::Zero(bodies), Vector::Zero(bodies)};
  start.qdot[body] = speed;
  return start;
}

// The motion for so long, held against the independent one.
support::RecordedRun expect_as_integrated(const System& system, const State& start,
                                          double duration) {
  SimulationOptions options = support::for_seconds(duration);
  options.energy = true;
  support::RecordedRun run = support::record_run(system, start, options);
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  const support::Chain given{system, start, duration};
  const std::optional<State> expected = support::MixedChainMotion(given).run(1000);
  if (!expected || run.result.outcome != RunOutcome::kReachedEnd) {
    ADD_FAILURE();
    return run;
  }
  EXPECT_LT((run.result.final.q - expected->q).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((run.result.final.qdot - expected->qdot).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(run.result.totals.energy_added, 1e-12);
  return run;
}

std::vector<int> stops_of(const std::vector<Event>& events, EventKind kind) {
  std::vector<int> list;
  for (const Event& event : events)
    if (event.kind == kind) list.push_back(event.stop);
  return list;
}

// Body 3 strikes body 4: they exchange their speeds over half a period of two equal masses on the
// spring. Bodies 1 and 2 touch, and the spring that body 3 leaves touches body 2: nothing moves
// them, before and after.
TEST(TouchingStops, WhatNothingMovesStaysAtRest) {
  for (const double stiffness : {1.0, 100.0}) {
    const System system =
        chain(4, {rigid(4, 0, 0.5), spring(4, 1, 10.0, 1.5), spring(4, 2, stiffness, 1.0)});
    const auto run = support::record_run(system, thrown(4, 2, 1.0), support::for_seconds(5.0));
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    const double contact = std::numbers::pi / std::sqrt(2.0 * stiffness);
    EXPECT_EQ(run.result.final.q[0], 0.0);
    EXPECT_EQ(run.result.final.q[1], 0.0);
    EXPECT_NEAR(run.result.final.q[2], contact / 2.0, 1e-13);
    EXPECT_NEAR(run.result.final.q[3], 5.0 - contact / 2.0, 1e-13);
    EXPECT_NEAR(run.result.final.qdot[2], 0.0, 1e-13);
    EXPECT_NEAR(run.result.final.qdot[3], 1.0, 1e-13);
    EXPECT_TRUE(stops_of(run.events, EventKind::kRelease).empty());
  }
}

// Body 4 is thrown at body 3, and the spring before that presses body 2 against body 1 as t^3,
// under Hertz's law as t^5.25: they go on as one.
TEST(TouchingStops, IsHeldByAForceOfAHigherPower) {
  for (const double exponent : {1.0, 1.5, 2.2}) {
    const System system =
        chain(4, {rigid(4, 0, 0.8), spring(4, 1, 1.0, exponent), spring(4, 2, 100.0, exponent)});
    const auto run = expect_as_integrated(system, thrown(4, 3, -1.0), 6.0);
    const std::vector<int> held = stops_of(run.events, EventKind::kStick);
    ASSERT_FALSE(held.empty());
    EXPECT_EQ(held.front(), 0);
    // It is not told to be held before it is, nor to be let go.
    EXPECT_TRUE(std::none_of(run.events.begin(), run.events.end(), [](const Event& event) {
      return event.kind == EventKind::kRelease && event.time < 0.1;
    }));
  }
}

// Mirrored, the same springs press body 3 away from body 2: the gap there opens as t^5 or t^7.25,
// and nobody ever held it.
TEST(TouchingStops, IsLeftByAHigherPower) {
  for (const double exponent : {1.0, 1.5, 2.2}) {
    const System system = chain(5, {spring(5, 0, 100.0, exponent), spring(5, 1, 1.0, exponent),
                                    spring(5, 2, 10.0, exponent), rigid(5, 3, 0.5)});
    expect_as_integrated(system, thrown(5, 0, 1.0), 8.0);
    const System other = chain(5, {rigid(5, 0, 0.5), spring(5, 1, 100.0, exponent),
                                   rigid(5, 2, 0.5), spring(5, 3, 1.0, exponent)});
    expect_as_integrated(other, thrown(5, 1, 1.0), 8.0);
  }
}

// Several at once, of which the first that presses decides for the others.
TEST(TouchingStops, ShareWhatReachesThemTogether) {
  for (const double exponent : {1.0, 1.5})
    for (const double restitution : {0.0, 0.8, 1.0}) {
      const System system =
          chain(6, {spring(6, 0, 10.0, exponent), spring(6, 1, 100.0, exponent),
                    rigid(6, 2, restitution), rigid(6, 3, restitution), rigid(6, 4, restitution)});
      expect_as_integrated(system, thrown(6, 0, 1.0), 10.0);
      expect_as_integrated(system, thrown(6, 1, -1.0), 10.0);
      expect_as_integrated(system, thrown(6, 5, -1.0), 10.0);
    }
}

System forced_chain(Eigen::Index bodies, std::vector<Stop> stops, const Vector& force) {
  // cos(t - pi/2): a sine, which begins at zero.
  return support::forced(chain(bodies, std::move(stops)), 1.0, -0.5 * std::numbers::pi, force);
}

// A force sin t on the first of n bodies presses them all together, x = (t - sin t)/n until it
// turns; pulling, it takes that body away, and nothing moves the others.
TEST(TouchingStops, AreDecidedByAForceThatBeginsAtZero) {
  for (Eigen::Index n = 2; n <= 6; ++n)
    for (const double restitution : {0.0, 0.5, 1.0}) {
      std::vector<Stop> stops;
      for (Eigen::Index i = 0; i + 1 < n; ++i) stops.push_back(rigid(n, i, restitution));
      const Vector first = Vector::Unit(n, 0);
      const double t = 3.0, whole = t - std::sin(t);
      SimulationOptions options = support::for_seconds(t);
      const Simulation pressed =
          support::record_run(forced_chain(n, stops, first), thrown(n, 0, 0.0), options).result;
      ASSERT_EQ(pressed.outcome, RunOutcome::kReachedEnd) << pressed.message;
      const Simulation pulled =
          support::record_run(forced_chain(n, stops, -first), thrown(n, 0, 0.0), options).result;
      ASSERT_EQ(pulled.outcome, RunOutcome::kReachedEnd) << pulled.message;
      EXPECT_NEAR(pulled.final.q[0], -whole, 1e-14);
      for (Eigen::Index i = 0; i < n; ++i) {
        EXPECT_NEAR(pressed.final.q[i], whole / static_cast<double>(n), 1e-14);
        if (i > 0) {
          EXPECT_NEAR(pulled.final.q[i], 0.0, 1e-15);
        }
      }
    }
}

// The same force on every body moves them as one, whatever is between them.
TEST(TouchingStops, AreNotMovedByWhatMovesAllAlike) {
  for (const double exponent : {1.0, 1.5}) {
    const System system =
        forced_chain(3, {spring(3, 0, 100.0, exponent), rigid(3, 1, 0.8)}, Vector::Ones(3));
    const double t = 9.0;
    const Simulation run =
        support::record_run(system, thrown(3, 0, 0.0), support::for_seconds(t)).result;
    ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
    for (const double q : run.final.q) EXPECT_NEAR(q, t - std::sin(t), 1e-12);
  }
}

// Bodies 3 to 6 rest against each other under no force. The blows that body 1, under a load, gives
// body 2 do not reach them, nor do they part them: the first that does is shared by all.
TEST(TouchingStops, AreNotPartedByBlowsElsewhere) {
  System system = chain(6, {rigid(6, 0, 0.8), rigid(6, 1, 1.0), rigid(6, 2, 1.0), rigid(6, 3, 0.8),
                            rigid(6, 4, 0.0)});
  system.modal().load = Vector::Unit(6, 0);
  const auto run = expect_as_integrated(system, thrown(6, 1, -1.0), 2.0);
  EXPECT_TRUE(stops_of(run.events, EventKind::kRelease).empty());
}

// From rest, under a force that begins at zero and may end at it anywhere.
TEST(TouchingStops, RandomChainsUnderASine) {
  for (int i = 0; i < 60; ++i) {
    support::Dice dice(7000 + static_cast<std::uint64_t>(i));
    support::Chain given = support::mixed_chain(dice, 6);
    const Eigen::Index n = given.start.q.size();
    given.start.qdot.setZero();
    Vector force = Vector::Zero(n);
    force[dice.pick(static_cast<int>(n))] = dice.pick(2) == 0 ? 1.0 : -1.0;
    given.system =
        support::forced(given.system, dice.uniform(0.3, 3.0), -0.5 * std::numbers::pi, force);
    SCOPED_TRACE(i);
    expect_as_integrated(given.system, given.start, 4.0);
    if (HasFailure()) break;
  }
}

// Bodies that also hang on springs of their own, one of them driven. What the compressed springs do
// not reach is not moved by the rounding of their motion: the stop that chain 25 holds without a
// force was let go by it, and the next blow was not shared.
TEST(TouchingStops, RandomChainsOnSpringsOfTheirOwn) {
  for (int i = 0; i < 40; ++i) {
    support::Dice dice(static_cast<std::uint64_t>(i));
    support::Chain given = support::mixed_chain(dice, 6);
    const Eigen::Index n = given.start.q.size();
    const double frequency = dice.uniform(0.3, 3.0), phase = dice.uniform(-3.0, 3.0);
    Vector force = Vector::Zero(n);
    if (dice.pick(2) != 0)
      force[dice.pick(static_cast<int>(n))] = dice.pick(2) != 0 ? 1.0 : -1.0;
    else
      for (double& part : force) part = static_cast<double>(dice.pick(3) - 1);
    given.system = support::forced(given.system, frequency, phase, force);
    for (double& omega : given.system.omega) omega = dice.uniform(0.1, 1.0);
    SCOPED_TRACE(i);
    expect_as_integrated(given.system, given.start, 3.5);
    if (HasFailure()) break;
  }
}

// Chains of rigid stops and springs, of every length, one body thrown to either side.
TEST(TouchingStops, RandomChainsAsIntegrated) {
  for (int i = 0; i < 150; ++i) {
    support::Dice dice(3000 + static_cast<std::uint64_t>(i));
    const support::Chain given = support::mixed_chain(dice, 6);
    SCOPED_TRACE(i);
    expect_as_integrated(given.system, given.start, given.duration);
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace graze
