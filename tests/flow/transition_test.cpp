// Derivatives of the exact flow against central differences, in every kind of mode.
#include "graze/flow/variation/detail/transition.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/differences.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Damped;
using support::Dice;

Vector end_of(const System& system, const Vector& y, double theta, double s) {
  const Eigen::Index n = system.modes();
  const ExactFlow<double> flow(system);
  const Transition arc = transition(system, flow, {y.head(n), y.tail(n)}, theta, s);
  Vector end(2 * n);
  end << arc.end.q, arc.end.qdot;
  return end;
}

Vector stacked(const State& state) {
  Vector y(2 * state.q.size());
  y << state.q, state.qdot;
  return y;
}

System system_of_kind(Damped kind, Dice& dice) {
  System system = support::random_system(dice, 2, 1.0);
  for (int j = 0; j < 2; ++j) support::set_mode(system, j, kind, system.forcing()->frequency, dice);
  return system;
}

class TransitionOf : public testing::TestWithParam<int> {
 protected:
  Damped kind() const { return static_cast<Damped>(GetParam()); }
};

TEST_P(TransitionOf, StartPhaseAndTimeAreDifferentiated) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(seed);
    System system = system_of_kind(kind(), dice);
    if (seed % 2 == 0) system.modal().load = dice.vector(2, -1.0, 1.0);
    const Vector y = dice.vector(4, -1.0, 1.0);
    const double theta = dice.uniform(0.0, 6.0), s = dice.uniform(0.1, 1.2) * system.period();
    const ExactFlow<double> flow(system);
    const Transition arc = transition(system, flow, {y.head(2), y.tail(2)}, theta, s);
    const double size = 1.0 + stacked(arc.end).norm() + stacked(arc.end_rate).norm();
    const Matrix by_start = support::central_jacobian(
        [&](const Vector& x) { return end_of(system, x, theta, s); }, y, Vector::Constant(4, 1e-2));
    EXPECT_LE((arc.flow.times(Matrix::Identity(4, 4)) - by_start).norm(), 1e-10 * size);
    const Vector by_phase =
        support::central_difference([&](double x) { return end_of(system, y, x, s); }, theta, 1e-3);
    EXPECT_LE((stacked(arc.phase_rate) - by_phase).norm(), 1e-10 * size);
    const Vector by_time =
        support::central_difference([&](double x) { return end_of(system, y, theta, x); }, s, 1e-3);
    EXPECT_LE((stacked(arc.end_rate) - by_time).norm(), 1e-8 * size);
  }
}

// The system moved along a tangent that touches every coefficient.
System moved(const System& system, const System& tangent, double h) {
  System there = system;
  there.omega += h * tangent.omega;
  there.modal().delta += h * tangent.delta();
  there.modal().forcing->frequency += h * tangent.forcing()->frequency;
  there.modal().forcing->amplitude += h * tangent.forcing()->amplitude;
  if (there.load()) *there.modal().load += h * *tangent.load();
  return there;
}

System random_tangent(Damped kind, Dice& dice) {
  System tangent{dice.vector(2, -1.0, 1.0), NaturalModes{dice.vector(2, -0.5, 0.5)}, {}};
  // A frequency or a damping of zero cannot fall.
  if (kind == Damped::kFreeMass) tangent.omega.setZero();
  tangent.modal().forcing =
      HarmonicForcing{dice.uniform(-1.0, 1.0), 0.0, dice.vector(2, -1.0, 1.0)};
  tangent.modal().load = dice.vector(2, -1.0, 1.0);
  return tangent;
}

TEST_P(TransitionOf, CoefficientsAreDifferentiatedAtFixedPhases) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(100 + seed);
    System system = system_of_kind(kind(), dice);
    if (seed % 2 == 0) system.modal().load = dice.vector(2, -1.0, 1.0);
    System tangent = random_tangent(kind(), dice);
    if (!system.load()) tangent.modal().load.reset();
    const Vector y = dice.vector(4, -1.0, 1.0);
    const double theta = dice.uniform(0.0, 6.0), turn = dice.uniform(0.5, 8.0);
    const double s = turn / system.forcing()->frequency;
    const ExactFlow<double> flow(system);
    const Vector rate =
        stacked(end_tangent(system, tangent, flow, {y.head(2), y.tail(2)}, theta, s));
    const Vector difference = support::central_difference(
        [&](double h) {
          const System there = moved(system, tangent, h);
          return end_of(there, y, theta, turn / there.forcing()->frequency);
        },
        0.0, 1e-4);
    EXPECT_LE((rate - difference).norm(), 1e-8 * (1.0 + rate.norm()));
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, TransitionOf, testing::Range(0, support::kDampedKinds));

TEST(Transition, OverNoTimeChangesNothing) {
  Dice dice(1);
  const System system = support::random_system(dice, 3, 1.0);
  const ExactFlow<double> flow(system);
  const State start{dice.vector(3, -1.0, 1.0), dice.vector(3, -1.0, 1.0)};
  const Transition arc = transition(system, flow, start, 0.5, 0.0);
  EXPECT_LE((arc.flow.times(Matrix::Identity(6, 6)) - Matrix::Identity(6, 6)).norm(), 1e-15);
  EXPECT_LE((arc.end.q - start.q).norm() + (arc.end.qdot - start.qdot).norm(), 1e-14);
  EXPECT_EQ(arc.phase_rate.q.norm() + arc.phase_rate.qdot.norm(), 0.0);
}

TEST(Transition, RunsBackwards) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Dice dice(300 + seed);
    const System system = support::random_system(dice, 3, 1.0);
    if ((system.delta().array() * system.period() > 2.0).any()) continue;
    const ExactFlow<double> flow(system);
    const State start{dice.vector(3, -1.0, 1.0), dice.vector(3, -1.0, 1.0)};
    const double s = 0.4 * system.period();
    const State end = transition(system, flow, start, 0.5, s).end;
    const State back = transition(system, flow, end, 0.5 + flow.frequency() * s, -s).end;
    EXPECT_LE((back.q - start.q).norm() + (back.qdot - start.qdot).norm(), 1e-12) << seed;
  }
}

TEST(Transition, DeterminantDecaysWithTheDamping) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Dice dice(400 + seed);
    const System system = support::random_system(dice, 1, 1.0);
    const ExactFlow<double> flow(system);
    const double s = dice.uniform(0.1, 2.0);
    const FlowMatrix e = transition(system, flow, support::rest(system), 0.0, s).flow;
    const double determinant = e.qq[0] * e.vv[0] - e.qv[0] * e.vq[0];
    const double size = std::abs(e.qq[0] * e.vv[0]) + std::abs(e.qv[0] * e.vq[0]);
    EXPECT_NEAR(determinant, std::exp(-2.0 * system.delta()[0] * s), 4e-15 * size + 1e-16) << seed;
  }
}

}  // namespace
}  // namespace graze
