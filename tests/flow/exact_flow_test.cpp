// The exact flow: its 50-digit form against the equations of motion, double precision against it.
#include "graze/flow/exact/detail/exact_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/flow/exact/extended.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Damped;
using support::Dice;
using Wide = RealVector<Extended>;

// One forced mode of the given kind.
System one_mode(Damped kind, Dice& dice) {
  System system = support::random_system(dice, 1, 1.0);
  support::set_mode(system, 0, kind, system.forcing()->frequency, dice);
  return system;
}

struct WideState {
  Extended q, qdot;
};

WideState state_at(const Arc<Extended>& arc, const Extended& s) {
  Wide q(1), qdot(1);
  arc.state(s, q, qdot);
  return {q[0], qdot[0]};
}

// Derivative of a function by central differences of order 8: error h^8 f^(9)/630.
template <class F>
Extended eighth_order(const F& f, const Extended& s, const Extended& h) {
  return (672 * (f(s + h) - f(s - h)) - 168 * (f(s + 2 * h) - f(s - 2 * h)) +
          32 * (f(s + 3 * h) - f(s - 3 * h)) - 3 * (f(s + 4 * h) - f(s - 4 * h))) /
         (840 * h);
}

TEST(ExactFlow, SolvesTheEquationOfMotionInEveryKindOfMode) {
  const Extended h("1e-5");
  for (int kind = 0; kind < support::kDampedKinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      Dice dice(100 * static_cast<std::uint64_t>(kind) + seed);
      const System system = one_mode(static_cast<Damped>(kind), dice);
      const ExactFlow<Extended> flow(system);
      Arc<Extended> arc(flow);
      const Extended q0 = dice.uniform(-1.0, 1.0), v0 = dice.uniform(-1.0, 1.0), theta = 0.4;
      arc.start(theta, Wide::Constant(1, q0), Wide::Constant(1, v0));
      EXPECT_LE(abs(state_at(arc, 0).q - q0), Extended(1e-45));
      EXPECT_LE(abs(state_at(arc, 0).qdot - v0), Extended(1e-45));
      const Extended omega = system.omega[0], delta = system.delta()[0];
      const Extended force = system.forcing()->amplitude[0],
                     frequency = system.forcing()->frequency;
      for (const double at : {0.3, 1.7, 6.0}) {
        const Extended s = at;
        const WideState here = state_at(arc, s);
        const Extended rate =
            eighth_order([&](const Extended& x) { return state_at(arc, x).q; }, s, h);
        const Extended acceleration =
            eighth_order([&](const Extended& x) { return state_at(arc, x).qdot; }, s, h);
        const Extended expected =
            force * cos(theta + frequency * s) - 2 * delta * here.qdot - omega * omega * here.q;
        EXPECT_LE(abs(rate - here.qdot), Extended(1e-30));
        EXPECT_LE(abs(acceleration - expected), Extended(1e-29));
      }
    }
  }
}

TEST(ExactFlow, DoublePrecisionAgreesWithFiftyDigits) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Dice dice(seed);
    const System system = support::random_system(dice, 1 + dice.pick(5), 1.0);
    const int n = system.modes();
    const Vector q0 = dice.vector(n, -1.0, 1.0), v0 = dice.vector(n, -1.0, 1.0);
    const double theta = dice.uniform(0.0, 6.0), s = dice.uniform(0.0, 2.0) * system.period();
    const ExactFlow<double> flow(system);
    const ExactFlow<Extended> wide_flow(system);
    Arc<double> arc(flow);
    Arc<Extended> wide_arc(wide_flow);
    arc.start(theta, q0, v0);
    wide_arc.start(theta, q0.cast<Extended>(), v0.cast<Extended>());
    Vector q(n), qdot(n);
    Wide wide_q(n), wide_qdot(n);
    arc.state(s, q, qdot);
    wide_arc.state(s, wide_q, wide_qdot);
    for (int j = 0; j < n; ++j) {
      // Relative to the size of the motion: its start, its response, and their velocities.
      const double rate = std::max(system.omega[j], system.forcing()->frequency);
      const double size = 1.0 + std::abs(q[j]) + std::abs(qdot[j]) / rate;
      EXPECT_NEAR(q[j], static_cast<double>(wide_q[j]), 1e-13 * size)
          << "seed " << seed << " omega " << system.omega[j] << " delta " << system.delta()[j];
      EXPECT_NEAR(qdot[j], static_cast<double>(wide_qdot[j]), 1e-13 * size * std::max(rate, 1.0))
          << "seed " << seed << " omega " << system.omega[j] << " delta " << system.delta()[j];
    }
  }
}

TEST(ExactFlow, TwoArcsMakeOne) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Dice dice(5000 + seed);
    const System system = support::random_system(dice, 3, 1.0);
    const ExactFlow<double> flow(system);
    Arc<double> arc(flow);
    const Vector q0 = dice.vector(3, -1.0, 1.0), v0 = dice.vector(3, -1.0, 1.0);
    const double first = dice.uniform(0.0, 3.0), second = dice.uniform(0.0, 3.0);
    Vector q(3), qdot(3), whole_q(3), whole_qdot(3);
    arc.start(0.7, q0, v0);
    arc.state(first + second, whole_q, whole_qdot);
    arc.state(first, q, qdot);
    arc.start(0.7 + flow.frequency() * first, q, qdot);
    arc.state(second, q, qdot);
    EXPECT_LE((q - whole_q).norm(), 1e-12) << "seed " << seed;
    EXPECT_LE((qdot - whole_qdot).norm(), 1e-11) << "seed " << seed;
  }
}

TEST(ExactFlow, FreeMassKeepsItsSpeedWithoutForce) {
  const System system = support::oscillator(0.0, 0.0, 1.0, 0.8);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(0.0, Vector::Constant(1, 0.25), Vector::Constant(1, -3.0));
  Vector q(1), qdot(1);
  arc.state(1e6, q, qdot);
  EXPECT_EQ(q[0], 0.25 - 3e6);
  EXPECT_EQ(qdot[0], -3.0);
  EXPECT_FALSE(flow.forced());
  EXPECT_EQ(flow.period(), std::numeric_limits<double>::infinity());
}

TEST(ExactFlow, OverdampedMotionDoesNotOverflow) {
  const System system = support::oscillator(1.0, 1e3, 1.0, 0.8);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(0.0, Vector::Ones(1), Vector::Zero(1));
  Vector q(1), qdot(1);
  arc.state(1e4, q, qdot);
  // The slow rate is 1/(delta + sqrt(delta^2 - 1)) = 5.00000125e-4 to 12 digits.
  const double slow = 1.0 / (1e3 + std::sqrt(1e6 - 1.0));
  EXPECT_NEAR(q[0] / (std::exp(-slow * 1e4) * (1.0 + slow / 2e3)), 1.0, 1e-9);
}

TEST(ExactFlow, KindsAreChosenByDampingAndDetuning) {
  const auto kind = [](double omega, double zeta, double frequency) {
    return ExactFlow<double>(
               support::forced_oscillator(omega, zeta * omega, 1.0, 0.8, frequency, 1.0))
        .mode(0)
        .kind;
  };
  EXPECT_EQ(kind(1.0, 0.1, 3.0), ModeKind::kOscillatory);
  EXPECT_EQ(kind(1.0, 2.0, 3.0), ModeKind::kOverdamped);
  EXPECT_EQ(kind(1.0, 1.0, 3.0), ModeKind::kNearCritical);
  EXPECT_EQ(kind(0.0, 0.0, 3.0), ModeKind::kNearCritical);
  EXPECT_EQ(kind(1.0, 0.0, 1.0), ModeKind::kFromRest);
}

}  // namespace
}  // namespace graze
