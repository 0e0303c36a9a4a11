// Compliant stops that touch at rest: which of them are entered is decided by derivatives of their
// gaps of any order, and not of a whole one on a spring of Hertz.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/motion/detail/motion.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/system/detail/gap_value.hpp"
#include "support/chain_reference.hpp"

namespace graze {
namespace {

ContactForce spring(double stiffness, double exponent) {
  return {stiffness, exponent, ContactDamping::kNone};
}

Vector row_of(std::initializer_list<double> list) {
  return Eigen::Map<const Vector>(list.begin(), static_cast<Eigen::Index>(list.size()));
}

System free_bodies(Eigen::Index n) { return {Vector::Zero(n), NaturalModes{Vector::Zero(n)}, {}}; }

std::vector<double> entries(const std::vector<Event>& events) {
  std::vector<double> times;
  for (const Event& event : events)
    if (event.kind == EventKind::kContact) times.push_back(event.time);
  return times;
}

// A body that strikes another one, which touches a wall: by SciPy's DOP853 with the tolerance
// 1e-12.
TEST(TouchingSprings, TwoBodiesAtAWall) {
  System system = free_bodies(2);
  system.stops.push_back({row_of({1.0, -1.0}), 0.0, spring(1.0, 1.5)});
  system.stops.push_back({row_of({0.0, 1.0}), 0.0, spring(1.0, 1.5)});
  SimulationOptions options = support::for_seconds(6.0);
  options.energy = true;
  const auto run = support::record_run(system, support::state_of({0.0, 0.0}, {1.0, 0.0}), options);
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_NEAR(run.result.final.q[0], -0.3784655, 6e-8);
  EXPECT_NEAR(run.result.final.q[1], -0.3062407, 6e-8);
  EXPECT_NEAR(run.result.final.qdot[0], -0.9907490, 6e-8);
  EXPECT_NEAR(run.result.final.qdot[1], -0.1357069, 6e-8);
  EXPECT_EQ(run.result.totals.energy_added, 0.0);
  const std::vector<double> times = entries(run.events);
  ASSERT_GE(times.size(), 2u);
  EXPECT_EQ(times[0], 0.0);
  EXPECT_EQ(times[1], 0.0);
}

// Four equal masses with linear springs: SciPy's DOP853 likewise.
TEST(TouchingSprings, FourBodies) {
  System system = free_bodies(4);
  for (Eigen::Index i = 0; i < 3; ++i) {
    Vector row = Vector::Zero(4);
    row[i] = 1.0;
    row[i + 1] = -1.0;
    system.stops.push_back({row, 0.0, spring(1.0, 1.0)});
  }
  const auto run =
      support::record_run(system, support::state_of({0.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}),
                          support::for_seconds(40.0));
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  const double expected[] = {-0.1322753, -0.0649748, 0.2369776, 0.9602724};
  for (Eigen::Index i = 0; i < 4; ++i)
    EXPECT_NEAR(run.result.final.qdot[i], expected[i], 6e-8) << i;
}

// x'' + (1 + k) x = a sin(W t) while the spring is compressed, from rest on it.
TEST(TouchingSprings, AtRestUnderAForceThatBegins) {
  for (const double k : {0.3, 0.5, 1.0, 2.0, 7.0, 10.0, 20.0, 33.0})
    for (const double frequency : {0.3, 0.5, 0.9, 1.0, 1.3, 2.0, 20.0})
      for (const ContactDamping damping : {ContactDamping::kNone, ContactDamping::kConstant}) {
        System system = support::oscillator(1.0, 0.0, 0.0, 0.0);
        system.stops.front().law = ContactForce{k, 1.0, damping, 0.1};
        system.modal().forcing =
            HarmonicForcing{frequency, -std::numbers::pi / 2.0, Vector::Ones(1)};
        const double until = 0.5 * std::numbers::pi / std::max(frequency, std::sqrt(1.0 + k));
        const auto run =
            support::record_run(system, support::rest(system), support::for_seconds(until));
        ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd)
            << k << " " << frequency << " " << run.result.message;
        EXPECT_EQ(entries(run.events), std::vector<double>{0.0});
        const State expected = support::integrated_chain({system, support::rest(system), until});
        EXPECT_NEAR(run.result.final.q[0], expected.q[0], 1e-11) << k << " " << frequency;
      }
}

// The numbers: one contact, from 0 to 3.4266.
TEST(TouchingSprings, OneContactUnderASine) {
  System system = support::oscillator(1.0, 0.0, 0.0, 0.0);
  system.stops.front().law = spring(10.0, 1.0);
  system.modal().forcing = HarmonicForcing{1.0, -std::numbers::pi / 2.0, Vector::Ones(1)};
  const auto run = support::record_run(system, support::rest(system), support::for_seconds(6.0));
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_NEAR(run.result.final.q[0], -1.56471242, 6e-9);
  EXPECT_NEAR(run.result.final.qdot[0], -0.32387245, 6e-9);
  EXPECT_EQ(entries(run.events), std::vector<double>{0.0});
}

// A force s (1 - cos t), which presses or pulls by its second derivative only.
TEST(TouchingSprings, AtRestUnderAForceWhoseSecondDerivativeBegins) {
  for (const double sense : {1.0, -1.0})
    for (const double exponent : {1.0, 1.5, 2.3}) {
      System system = support::oscillator(0.5, 0.0, 0.0, 0.0);
      system.stops.front().law = spring(3.0, exponent);
      system.modal().load = Vector::Constant(1, sense);
      system.modal().forcing = HarmonicForcing{1.0, std::numbers::pi, Vector::Constant(1, sense)};
      const support::Chain chain{system, support::rest(system), 5.0};
      const auto run = support::record_run(system, chain.start, support::for_seconds(5.0));
      ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
      const State expected = support::integrated_chain(chain);
      EXPECT_NEAR(run.result.final.q[0], expected.q[0], 1e-10) << sense << " " << exponent;
      EXPECT_NEAR(run.result.final.qdot[0], expected.qdot[0], 1e-10) << sense << " " << exponent;
    }
}

// The instant of a contact is rounded, the contact is not: also where the gap is zero, and with it
// all that its rounding is told by, the structure lies on the surface that it has reached.
TEST(TouchingSprings, WhatIsReachedIsReached) {
  for (const double shape : {1.2, 0.7, 1.0 / 3.0})
    for (const double start : {-0.3, -0.07, -1.0}) {
      System system = support::oscillator(1.0, 0.0, 0.0, 0.0);
      system.stops.front().row[0] = shape;
      system.stops.front().law = spring(85.0, 1.0);
      system = support::forced(system, 2.0, 0.3, Vector::Constant(1, 0.1));
      Motion<double> motion(system, {}, Vector::Constant(1, start), Vector::Zero(1));
      Arrival<double> arrival;
      do arrival = motion.fly(motion.flow().period());
      while (arrival.kind == ArrivalKind::kTime);
      ASSERT_EQ(arrival.kind, ArrivalKind::kTouch);
      const GapValue<double> gap = gap_value<double>(system.stops[0].row, motion.q(), 0.0);
      EXPECT_LE(std::abs(gap.value), gap.rounding) << shape << " " << start;
    }
}

// What rests elsewhere is not touched by what moves: its flight keeps its closed form.
TEST(TouchingSprings, BodiesThatNothingReachesRest) {
  System system = free_bodies(4);
  system.stops.push_back({row_of({1.0, -1.0, 0.0, 0.0}), 0.5, spring(1.0, 1.5)});
  system.stops.push_back({row_of({0.0, 0.0, 1.0, -1.0}), 0.0, spring(1.0, 1.5)});
  const auto run =
      support::record_run(system, support::state_of({0.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}),
                          support::for_seconds(10.0));
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  const std::vector<double> times = entries(run.events);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_NEAR(times[0], 0.5, 1e-15);
  EXPECT_EQ(run.result.final.q[3], 0.0);
}

TEST(TouchingSprings, ChainsAsIntegrated) {
  for (int i = 0; i < 40; ++i) {
    support::Dice dice(1000 + static_cast<std::uint64_t>(i));
    const support::Chain chain = support::touching_chain(dice, 7);
    const auto run =
        support::record_run(chain.system, chain.start, support::for_seconds(chain.duration));
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << i << " " << run.result.message;
    const State expected = support::integrated_chain(chain);
    EXPECT_LT((run.result.final.q - expected.q).cwiseAbs().maxCoeff(), 1e-8) << i;
    EXPECT_LT((run.result.final.qdot - expected.qdot).cwiseAbs().maxCoeff(), 1e-8) << i;
  }
}

}  // namespace
}  // namespace graze
