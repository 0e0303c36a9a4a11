// The gap along an arc: its bounds against dense sampling, its noise against 50 digits.
#include "graze/flow/gap_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "graze/flow/extended.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Damped;
using support::Dice;

// Derivatives 0..4 of the gap from the state and the equation of motion.
std::array<double, 5> gap_derivatives(const System& system, const Arc<double>& arc, double s) {
  const int n = system.modes();
  Vector q(n), v(n);
  arc.state(s, q, v);
  const double w = system.forcing->frequency, theta = arc.start_phase() + w * s;
  const Vector& f = system.forcing->amplitude;
  const Vector w2 = system.omega.cwiseAbs2(), d2 = 2.0 * system.delta;
  const Vector a = f * std::cos(theta) - d2.cwiseProduct(v) - w2.cwiseProduct(q);
  const Vector b = -f * w * std::sin(theta) - d2.cwiseProduct(a) - w2.cwiseProduct(v);
  const Vector c = -f * w * w * std::cos(theta) - d2.cwiseProduct(b) - w2.cwiseProduct(a);
  const Vector& row = system.stops[0].row;
  return {system.stops[0].gap - row.dot(q), -row.dot(v), -row.dot(a), -row.dot(b), -row.dot(c)};
}

void expect_bounds(const System& system, const Vector& q, const Vector& v, double window) {
  constexpr int kSamples = 400;
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(system.forcing->phase, q, v);
  const GapCurve<double> curve(arc, system.stops[0].row, system.stops[0].gap, window, false);
  std::array<double, 3> largest{};  // of |derivative m + 2| from the sample on
  for (int i = kSamples; i >= 0; --i) {
    const double s = window * i / kSamples;
    const std::array<double, 5> exact = gap_derivatives(system, arc, s);
    for (std::size_t m = 0; m < 3; ++m) {
      largest[m] = std::max(largest[m], std::abs(exact[m + 2]));
      const CurvePoint<double> point = curve.at(s, static_cast<int>(m));
      const double rounding = 1e-12 * (std::abs(exact[m + 2]) + point.bound + 1.0);
      EXPECT_LE(largest[m], point.bound + rounding) << "m " << m << ", s " << s;
      EXPECT_NEAR(point.value, exact[m], rounding) << "m " << m << ", s " << s;
      EXPECT_NEAR(point.slope, exact[m + 1], rounding) << "m " << m << ", s " << s;
    }
  }
}

TEST(GapCurve, BoundsHoldInEveryKindOfMode) {
  for (int kind = 0; kind < support::kDampedKinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      Dice dice(100 * static_cast<std::uint64_t>(kind) + seed);
      System system = support::random_system(dice, 1, 0.5);
      support::set_mode(system, 0, static_cast<Damped>(kind), system.forcing->frequency, dice);
      expect_bounds(system, dice.vector(1, -1.0, 1.0), dice.vector(1, -1.0, 1.0), system.period());
    }
  }
}

TEST(GapCurve, BoundsHoldForManyModes) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(9000 + seed);
    const System system = support::random_system(dice, 4, 0.5);
    expect_bounds(system, dice.vector(4, -1.0, 1.0), dice.vector(4, -1.0, 1.0),
                  2.0 * system.period());
  }
}

void expect_noise(const System& system, const Vector& q, const Vector& v, bool on_stop) {
  const ExactFlow<double> flow(system);
  const ExactFlow<Extended> wide_flow(system);
  Arc<double> arc(flow);
  Arc<Extended> wide_arc(wide_flow);
  const double theta = system.forcing->phase, window = system.period();
  arc.start(theta, q, v);
  wide_arc.start(theta, q.cast<Extended>(), v.cast<Extended>());
  const GapCurve<double> curve(arc, system.stops[0].row, system.stops[0].gap, window, on_stop);
  const GapCurve<Extended> wide(wide_arc, system.stops[0].row.cast<Extended>(),
                                Extended(system.stops[0].gap), Extended(window), on_stop);
  for (const double part : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 0.37, 0.8, 1.0}) {
    for (int m = 0; m < 3; ++m) {
      const CurvePoint<double> point = curve.at(part * window, m);
      const Extended exact = wide.at(Extended(part * window), m).value;
      EXPECT_LE(std::abs(static_cast<double>(exact - point.value)), point.noise)
          << "m " << m << ", s/T " << part << ", on stop " << on_stop;
    }
  }
}

TEST(GapCurve, NoiseBoundsTheErrorOfEveryKindOfMode) {
  for (int kind = 0; kind < support::kDampedKinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      Dice dice(20'000 + 100 * static_cast<std::uint64_t>(kind) + seed);
      System system = support::random_system(dice, 1, 0.5);
      support::set_mode(system, 0, static_cast<Damped>(kind), system.forcing->frequency, dice);
      const Vector q = dice.vector(1, -1.0, 1.0), v = dice.vector(1, -1.0, 1.0);
      expect_noise(system, q, v, false);
      expect_noise(system, q, v, true);
    }
  }
}

TEST(GapCurve, NoiseBoundsTheErrorOfManyModes) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(30'000 + seed);
    const System system = support::random_system(dice, 2 + dice.pick(4), 0.5);
    const int n = system.modes();
    expect_noise(system, dice.vector(n, -1.0, 1.0), dice.vector(n, -1.0, 1.0), seed % 2 == 0);
  }
}

// A stiff mode that starts on its forced response: what is free of it is rounding, and moves fast.
TEST(GapCurve, NoiseCoversTheRoundingOfAStartOnTheForcedResponse) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(40'000 + seed);
    System system = support::random_system(dice, 1, 0.5);
    system.omega[0] = 40.0 * system.forcing->frequency;
    system.delta[0] = 0.01;
    const ExactFlow<double> flow(system);
    const PlanarNumber<double> p = flow.mode(0).forced;
    const double c = std::cos(system.forcing->phase), s = std::sin(system.forcing->phase);
    const double w = flow.frequency();
    expect_noise(system, Vector::Constant(1, p.re * c - p.im * s),
                 Vector::Constant(1, -w * (p.re * s + p.im * c)), seed % 2 == 0);
  }
}

TEST(GapCurve, StartsOnTheStopAsAnIdentity) {
  Dice dice(3);
  for (int i = 0; i < 50; ++i) {
    const System system = support::random_system(dice, 3, 0.5);
    const ExactFlow<double> flow(system);
    Arc<double> arc(flow);
    const Vector v = 1e-9 * dice.vector(3, -1.0, 1.0);
    arc.start(0.3, dice.vector(3, -1.0, 1.0), v);
    const GapCurve<double> curve(arc, system.stops[0].row, 0.5, system.period(), true);
    EXPECT_EQ(curve.at(0.0, 0).value, 0.0);
    EXPECT_EQ(curve.start_derivative(0), 0.0);
  }
}

}  // namespace
}  // namespace graze
