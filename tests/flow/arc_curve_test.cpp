// The gap along an arc: its bounds against dense sampling, its noise against 50 digits.
#include "graze/flow/exact/detail/arc_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "graze/flow/exact/extended.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Damped;
using support::Dice;

// Derivatives 0..5 of an observable from the state and the equation of motion.
std::array<double, 6> derivatives(const System& system, const Observable<double>& observable,
                                  const Arc<double>& arc, double s) {
  const int n = system.modes();
  std::array<Vector, 7> x{Vector(n), Vector(n)};
  arc.state(s, x[0], x[1]);
  const double w = system.forcing()->frequency, theta = arc.start_phase() + w * s;
  const Vector w2 = system.omega.cwiseAbs2(), d2 = 2.0 * system.delta();
  for (std::size_t k = 2; k < x.size(); ++k) {
    const double turn = 0.5 * std::numbers::pi * static_cast<double>(k - 2);
    x[k] = system.forcing()->amplitude * (std::pow(w, k - 2) * std::cos(theta + turn)) -
           d2.cwiseProduct(x[k - 1]) - w2.cwiseProduct(x[k - 2]);
    if (k == 2 && system.load()) x[k] += *system.load();
  }
  std::array<double, 6> result{};
  for (std::size_t m = 0; m < result.size(); ++m) {
    const double turn = theta + 0.5 * std::numbers::pi * static_cast<double>(m);
    result[m] = observable.displacement.dot(x[m]) +
                std::pow(w, m) * (observable.harmonic.re * std::cos(turn) -
                                  observable.harmonic.im * std::sin(turn));
    if (observable.velocity.size() > 0) result[m] += observable.velocity.dot(x[m + 1]);
  }
  result[0] += observable.constant;
  return result;
}

// The gap of the system's stop, or anything else that is linear.
Observable<double> observable_of(const System& system, Dice& dice, bool gap) {
  const Stop& stop = system.stops[0];
  if (gap) return gap_observable<double>(stop.row, stop.gap);
  const int n = system.modes();
  return {dice.uniform(-1.0, 1.0),
          dice.vector(n, -1.0, 1.0),
          dice.vector(n, -1.0, 1.0),
          {dice.uniform(-1.0, 1.0), dice.uniform(-1.0, 1.0)}};
}

// Every second system carries a constant load.
void add_load(System& system, Dice& dice, std::uint64_t seed) {
  if (seed % 2 == 0) system.modal().load = dice.vector(system.modes(), -1.0, 1.0);
}

void expect_bounds(const System& system, const Observable<double>& observable, const Vector& q,
                   const Vector& v, double window) {
  constexpr int kSamples = 400;
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(system.forcing()->phase, q, v);
  const ArcCurve<double> curve(arc, observable, window, false);
  const double quickest =
      (system.omega + 2.0 * system.delta()).maxCoeff() + system.forcing()->frequency;
  std::array<double, 4> largest{};  // of |derivative m + 2| from the sample on
  for (int i = kSamples; i >= 0; --i) {
    const double s = window * i / kSamples;
    const std::array<double, 6> exact = derivatives(system, observable, arc, s);
    for (std::size_t m = 0; m < 4; ++m) {
      largest[m] = std::max(largest[m], std::abs(exact[m + 2]));
      const CurvePoint<double> point = curve.at(s, static_cast<int>(m));
      // The expected derivatives come from the equation of motion, which multiplies rounding.
      const double rounding =
          1e-12 * (std::abs(exact[m + 2]) + point.bound + 1.0) + 1e-14 * std::pow(quickest, m + 2);
      EXPECT_LE(largest[m], point.bound + rounding) << "m " << m << ", s " << s;
      EXPECT_NEAR(point.value, exact[m], rounding) << "m " << m << ", s " << s;
      EXPECT_NEAR(point.slope, exact[m + 1], rounding) << "m " << m << ", s " << s;
    }
  }
}

TEST(ArcCurve, BoundsHoldInEveryKindOfMode) {
  for (int kind = 0; kind < support::kDampedKinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      Dice dice(100 * static_cast<std::uint64_t>(kind) + seed);
      System system = support::random_system(dice, 1, 0.5);
      support::set_mode(system, 0, static_cast<Damped>(kind), system.forcing()->frequency, dice);
      add_load(system, dice, seed);
      expect_bounds(system, observable_of(system, dice, seed % 3 == 0), dice.vector(1, -1.0, 1.0),
                    dice.vector(1, -1.0, 1.0), system.period());
    }
  }
}

TEST(ArcCurve, BoundsHoldForManyModes) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(9000 + seed);
    System system = support::random_system(dice, 4, 0.5);
    add_load(system, dice, seed);
    expect_bounds(system, observable_of(system, dice, seed % 3 == 0), dice.vector(4, -1.0, 1.0),
                  dice.vector(4, -1.0, 1.0), 2.0 * system.period());
  }
}

Observable<Extended> widened(const Observable<double>& o) {
  return {o.constant,
          o.displacement.cast<Extended>(),
          o.velocity.cast<Extended>(),
          {o.harmonic.re, o.harmonic.im}};
}

void expect_noise(const System& system, const Observable<double>& observable, const Vector& q,
                  const Vector& v, bool on_stop) {
  const ExactFlow<double> flow(system);
  const ExactFlow<Extended> wide_flow(system);
  Arc<double> arc(flow);
  Arc<Extended> wide_arc(wide_flow);
  const double theta = system.forcing()->phase, window = system.period();
  arc.start(theta, q, v);
  wide_arc.start(theta, q.cast<Extended>(), v.cast<Extended>());
  const ArcCurve<double> curve(arc, observable, window, on_stop);
  const ArcCurve<Extended> wide(wide_arc, widened(observable), Extended(window), on_stop);
  for (const double part : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 0.37, 0.8, 1.0}) {
    for (int m = 0; m < 4; ++m) {
      const CurvePoint<double> point = curve.at(part * window, m);
      const Extended exact = wide.at(Extended(part * window), m).value;
      EXPECT_LE(std::abs(static_cast<double>(exact - point.value)), point.noise)
          << "m " << m << ", s/T " << part << ", on stop " << on_stop;
    }
  }
}

TEST(ArcCurve, NoiseBoundsTheErrorOfEveryKindOfMode) {
  for (int kind = 0; kind < support::kDampedKinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      Dice dice(20'000 + 100 * static_cast<std::uint64_t>(kind) + seed);
      System system = support::random_system(dice, 1, 0.5);
      support::set_mode(system, 0, static_cast<Damped>(kind), system.forcing()->frequency, dice);
      add_load(system, dice, seed);
      const Vector q = dice.vector(1, -1.0, 1.0), v = dice.vector(1, -1.0, 1.0);
      const Observable<double> observable = observable_of(system, dice, seed % 3 == 0);
      expect_noise(system, observable, q, v, false);
      expect_noise(system, observable, q, v, true);
    }
  }
}

TEST(ArcCurve, NoiseBoundsTheErrorOfManyModes) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(30'000 + seed);
    System system = support::random_system(dice, 2 + dice.pick(4), 0.5);
    add_load(system, dice, seed);
    const int n = system.modes();
    const Observable<double> observable = observable_of(system, dice, seed % 3 == 0);
    expect_noise(system, observable, dice.vector(n, -1.0, 1.0), dice.vector(n, -1.0, 1.0),
                 seed % 2 == 0);
  }
}

// A stiff mode that starts on its forced response: what is free of it is rounding, and moves fast.
TEST(ArcCurve, NoiseCoversTheRoundingOfAStartOnTheForcedResponse) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(40'000 + seed);
    System system = support::random_system(dice, 1, 0.5);
    system.omega[0] = 40.0 * system.forcing()->frequency;
    system.modal().delta[0] = 0.01;
    const ExactFlow<double> flow(system);
    const PlanarNumber<double> p = flow.mode(0).forced;
    const double c = std::cos(system.forcing()->phase), s = std::sin(system.forcing()->phase);
    const double w = flow.frequency();
    expect_noise(system, observable_of(system, dice, seed % 3 == 0),
                 Vector::Constant(1, p.re * c - p.im * s),
                 Vector::Constant(1, -w * (p.re * s + p.im * c)), seed % 2 == 0);
  }
}

TEST(ArcCurve, StartsOnTheStopAsAnIdentity) {
  Dice dice(3);
  for (int i = 0; i < 50; ++i) {
    const System system = support::random_system(dice, 3, 0.5);
    const ExactFlow<double> flow(system);
    Arc<double> arc(flow);
    const Vector v = 1e-9 * dice.vector(3, -1.0, 1.0);
    arc.start(0.3, dice.vector(3, -1.0, 1.0), v);
    const ArcCurve<double> curve(arc, gap_observable<double>(system.stops[0].row, 0.5),
                                 system.period(), true);
    EXPECT_EQ(curve.at(0.0, 0).value, 0.0);
  }
}

}  // namespace
}  // namespace graze
