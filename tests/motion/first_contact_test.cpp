// The certified first contact, against dense sampling and against 50 digits.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/flow/exact/detail/first_zero.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/motion/detail/motion.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Dice;

constexpr int kSamples = 20'000;

struct Sampled {
  double first_beyond = -1.0;  // s of the first sample beyond the stop; -1: none
  double highest = -1e300;     // largest reach row.q of all samples
};

Sampled sample_reach(const System& system, const State& start, double window) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  arc.start(system.forcing()->phase, start.q, start.qdot);
  Vector q(system.modes()), qdot(system.modes());
  Sampled sampled;
  for (int i = 1; i <= kSamples; ++i) {
    const double s = window * i / kSamples;
    arc.state(s, q, qdot);
    const double reach = system.stops[0].row.dot(q);
    sampled.highest = std::max(sampled.highest, reach);
    if (reach > system.stops[0].gap && sampled.first_beyond < 0.0) sampled.first_beyond = s;
  }
  return sampled;
}

// Motion on the first forcing period, as far as the first contact.
Arrival<double> first_arrival(const System& system, const State& start, double window) {
  Motion<double> motion(system, {}, start.q, start.qdot);
  return motion.fly(window);
}

TEST(FirstContact, NeverPassesASampleBeyondTheStop) {
  int contacts = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    const System system = support::random_system(dice, 1 + dice.pick(4), dice.uniform(0.05, 0.5));
    State start{dice.vector(system.modes(), -0.5, 0.5), dice.vector(system.modes(), -1.0, 1.0)};
    if (system.stops[0].row.dot(start.q) >= system.stops[0].gap) start.q.setZero();
    const double window = system.period();
    const Sampled sampled = sample_reach(system, start, window);
    const Arrival<double> arrival = first_arrival(system, start, window);
    if (arrival.kind == ArrivalKind::kContact) {
      ++contacts;
      EXPECT_GT(arrival.speed, 0.0) << "seed " << seed;
      if (sampled.first_beyond >= 0.0) {
        EXPECT_LE(arrival.flight, sampled.first_beyond) << "seed " << seed;
      }
    } else {
      EXPECT_EQ(arrival.kind, ArrivalKind::kTime) << "seed " << seed;
      EXPECT_LT(sampled.first_beyond, 0.0) << "missed a contact, seed " << seed;
    }
  }
  EXPECT_GT(contacts, 50);
}

TEST(FirstContact, FindsTheShallowestSampledPenetration) {
  // The stop is put just under the highest sample of the free motion: the contact then lasts about
  // as long as a sample's distance, and less.
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      Dice dice(1000 + seed);
      System system = support::random_system(dice, 1 + dice.pick(4), 0.0);
      const State start{dice.vector(system.modes(), -0.5, 0.5),
                        dice.vector(system.modes(), -1.0, 1.0)};
      const double window = system.period();
      const Sampled sampled = sample_reach(system, start, window);
      system.stops[0].gap = sampled.highest - depth * std::abs(sampled.highest);
      if (system.stops[0].row.dot(start.q) >= system.stops[0].gap) continue;
      const double beyond = sample_reach(system, start, window).first_beyond;
      const Arrival<double> arrival = first_arrival(system, start, window);
      EXPECT_EQ(arrival.kind, ArrivalKind::kContact) << "depth " << depth << ", seed " << seed;
      EXPECT_LE(arrival.flight, beyond) << "depth " << depth << ", seed " << seed;
    }
  }
}

TEST(FirstContact, AgreesWithFiftyDigits) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Dice dice(2000 + seed);
    const System system = support::random_system(dice, 1 + dice.pick(4), dice.uniform(0.01, 0.3));
    const State start = support::rest(system);
    const Arrival<double> arrival = first_arrival(system, start, system.period());
    Motion<Extended> precise(system, {}, start.q.cast<Extended>(), start.qdot.cast<Extended>());
    const Arrival<Extended> expected = precise.fly(precise.flow().period());
    ASSERT_EQ(arrival.kind, expected.kind) << "seed " << seed;
    if (arrival.kind != ArrivalKind::kContact) continue;
    ++compared;
    const double speed = static_cast<double>(expected.speed);
    // An error e of the displacement moves the contact by e/v.
    const double error = std::abs(arrival.flight - static_cast<double>(expected.flight));
    EXPECT_LE(error * speed, 1e-14 * (1.0 + speed)) << "seed " << seed;
    const double expected_gap = static_cast<double>(precise.gap(0));
    EXPECT_LE(std::abs(expected_gap), 1e-45) << "seed " << seed;
  }
  EXPECT_GT(compared, 20);
}

// Curves made by hand: value, slope, bound and noise as the search wants them.
CurvePoint<double> parabola(double s, double touch, double lowest) {
  return {(s - touch) * (s - touch) + lowest, 2.0 * (s - touch), 2.0, 1e-16};
}

TEST(FirstContact, TouchWithinRoundingIsSaidToBeUndecided) {
  const auto zero = first_descent<double>([](double s) { return parabola(s, 1.0, 0.0); }, 0.0, 9.0);
  EXPECT_EQ(zero.kind, ZeroKind::kTouch);
  EXPECT_NEAR(zero.s, 1.0, 1e-7);
}

TEST(FirstContact, ParabolaAboveItsNoiseIsClear) {
  for (const double lowest : {1e-2, 1e-6, 1e-10, 1e-14}) {
    const auto zero =
        first_descent<double>([=](double s) { return parabola(s, 1.0, lowest); }, 0.0, 9.0);
    EXPECT_EQ(zero.kind, ZeroKind::kNone) << lowest;
  }
}

TEST(FirstContact, ParabolaBelowItsNoiseIsCrossedAtItsFirstRoot) {
  for (const double depth : {1e-2, 1e-6, 1e-10}) {
    const auto zero =
        first_descent<double>([=](double s) { return parabola(s, 1.0, -depth); }, 0.0, 9.0);
    ASSERT_EQ(zero.kind, ZeroKind::kCrossing) << depth;
    EXPECT_NEAR(zero.s, 1.0 - std::sqrt(depth), 1e-15 / std::sqrt(depth));
    EXPECT_NEAR(zero.slope, -2.0 * std::sqrt(depth), 1e-14 / std::sqrt(depth));
  }
}

TEST(FirstContact, NothingBeyondTheWindowCounts) {
  const auto line = [](double s) { return CurvePoint<double>{1.0 - s, -1.0, 0.0, 0.0}; };
  EXPECT_EQ(first_descent<double>(line, 0.0, 0.999).kind, ZeroKind::kNone);
  const auto zero = first_descent<double>(line, 0.0, 1.001);
  EXPECT_EQ(zero.kind, ZeroKind::kCrossing);
  EXPECT_EQ(zero.s, 1.0);
}

}  // namespace
}  // namespace graze
