// One certified arc after the other: walls on both sides, restarts, fifty digits.
#include "graze/motion/detail/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/flow/exact/extended.hpp"
#include "support/random_system.hpp"

namespace graze {
namespace {

using support::Dice;

// A free mass between walls at +-a.
System between_walls(double a, double restitution) {
  System system = support::oscillator(0.0, 0.0, a, restitution);
  system.stops.push_back({-Vector::Ones(1), a, ImpactLaw{-Vector::Ones(1), restitution}});
  return system;
}

TEST(Motion, FreeMassRattlesBetweenTwoWalls) {
  const System system = between_walls(0.5, 1.0);
  Motion<double> motion(system, {}, Vector::Zero(1), Vector::Constant(1, 2.0));
  for (int k = 0; k < 1000; ++k) {
    const Arrival<double> arrival = motion.fly(1e9);
    ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
    EXPECT_EQ(arrival.stop, k % 2);
    EXPECT_EQ(arrival.speed, 2.0);
    // Half a width first, whole ones after: powers of two, exact.
    EXPECT_EQ(motion.instant().local, 0.25 + 0.5 * k);
    motion.impact();
  }
}

TEST(Motion, FreeMassLosesSpeedBetweenTwoWalls) {
  const System system = between_walls(0.5, 0.5);
  Motion<double> motion(system, {}, Vector::Zero(1), Vector::Constant(1, 2.0));
  double time = 0.25, speed = 2.0;
  for (int k = 0; k < 40; ++k) {
    const Arrival<double> arrival = motion.fly(1e30);
    ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
    EXPECT_NEAR(motion.instant().local / time, 1.0, 1e-14);
    EXPECT_NEAR(arrival.speed / speed, 1.0, 1e-14);
    motion.impact();
    speed *= 0.5;
    time += 1.0 / speed;
  }
}

// A free mass thrown into the corner between two walls that meet at ten degrees. Below an angle its
// impacts follow each other without end ((1 + r_1)(1 + r_2)(b_1.b_2)^2 >= (sqrt r_1 + sqrt r_2)^2
// for unit rows) and it comes to rest in the corner after finite time; with r = 1/2 that time, by
// adding up 300 impacts with 80 digits, is 1.01425259067570478 s.
TEST(Motion, FreeMassComesToRestInANarrowCorner) {
  const double half = std::numbers::pi / 36.0;
  System system{Vector::Zero(2), NaturalModes{Vector::Zero(2)}, {}};
  for (const double side : {1.0, -1.0}) {
    const Vector row = Eigen::Vector2d(std::sin(half), side * std::cos(half));
    system.stops.push_back({row, 0.0, ImpactLaw{momentum_direction(row), 0.5}});
  }
  Motion<double> motion(system, {}, -Vector::Unit(2, 0), Eigen::Vector2d(1.0, 0.05));
  double energy = motion.qdot().squaredNorm(), last = 0.0;
  Arrival<double> arrival;
  for (int i = 0; i < 1000 && motion.instant().local < 2.0; ++i) {
    arrival = motion.fly(2.0);
    if (arrival.kind != ArrivalKind::kContact) continue;
    last = motion.instant().local;
    motion.impact();
    EXPECT_LE(motion.qdot().squaredNorm(), energy * (1.0 + 1e-15));
    energy = motion.qdot().squaredNorm();
  }
  EXPECT_EQ(arrival.kind, ArrivalKind::kTime);
  EXPECT_NEAR(last, 1.01425259067570478, 1e-14);
  EXPECT_LE(motion.q().norm(), 1e-15);
  EXPECT_LE(motion.qdot().norm(), 1e-15);
}

// A rigid bar, two free coordinates, dropped on two supports. Whatever the restitution it ends at
// rest on both: their static forces are both positive.
TEST(Motion, BarComesToRestOnTwoSupports) {
  for (const double r : {0.1, 0.2, 0.3, 0.4, 0.5, 0.8, 0.9}) {
    SCOPED_TRACE(r);
    System system{Vector::Zero(2), NaturalModes{Vector::Zero(2)}, {}};
    system.modal().load = Eigen::Vector2d(9.81, 0.0);
    for (const Vector& row :
         {Vector(Eigen::Vector2d(1.0, 1.5)), Vector(Eigen::Vector2d(1.0, -0.9))})
      system.stops.push_back(
          {row, row[1] > 0.0 ? 0.1 : 0.11, ImpactLaw{momentum_direction(row), r}});
    Motion<double> motion(system, {}, Vector::Zero(2), Vector::Zero(2));
    for (int impacts = 0; impacts < 5000 && motion.instant().local < 20.0;) {
      const Arrival<double> arrival = motion.fly(20.0);
      ASSERT_NE(arrival.kind, ArrivalKind::kUndecided);
      if (arrival.kind != ArrivalKind::kContact) continue;
      motion.impact();
      ++impacts;
    }
    EXPECT_EQ(motion.instant().local, 20.0);
    for (const int i : {0, 1}) {
      EXPECT_TRUE(motion.is_closed(i)) << i;
      EXPECT_NEAR(motion.gap(i), 0.0, 1e-13);
    }
  }
}

// One coordinate clamped between two stops without room, the other thrown against a third that
// touches both: it rebounds as v+ = -r v-, and the clamp stays as it is.
TEST(Motion, ClampedCoordinateStandsImpactsOfAnother) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(2200 + seed);
    System system{dice.vector(2, 10.0, 500.0), NaturalModes{Vector::Zero(2)}, {}};
    const Vector clamp = Eigen::Vector2d(dice.uniform(-1.0, 1.0), 0.0);
    const Vector struck = dice.vector(2, -1.0, 1.0);
    for (const Vector& row : {struck, clamp, Vector(-clamp)})
      system.stops.push_back(
          {row, 0.0, ImpactLaw{momentum_direction(row), dice.uniform(0.1, 0.9)}});
    system.stops[0].gap = 0.01;
    Motion<double> motion(system, {}, Vector::Zero(2), Eigen::Vector2d(0.0, 30.0 * struck[1]));
    Arrival<double> arrival = motion.fly(1.0);
    while (arrival.kind == ArrivalKind::kStick) arrival = motion.fly(1.0);
    if (arrival.kind == ArrivalKind::kTime) continue;  // does not come so far
    ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
    ASSERT_EQ(arrival.stop, 0);
    const double r = system.stops[0].restitution().at(arrival.speed);
    motion.impact();
    EXPECT_NEAR(struck.dot(motion.qdot()), -r * arrival.speed, 1e-13 * arrival.speed);
    EXPECT_NEAR(clamp.dot(motion.qdot()), 0.0, 1e-14 * arrival.speed);
    EXPECT_GE(motion.fly(1.0).flight, 0.0);
    EXPECT_NE(motion.fly(1.0).kind, ArrivalKind::kUndecided);
  }
}

TEST(Motion, EndsAFlightWhereItIsToldTo) {
  Motion<double> motion(support::oscillator(1.0, 0.0, 5.0, 0.8), {}, Vector::Ones(1),
                        Vector::Zero(1));
  for (const double until : {0.1, 0.3, 0.7, 100.0}) {
    EXPECT_EQ(motion.fly(until).kind, ArrivalKind::kTime);
    EXPECT_EQ(motion.instant().local, until);
    EXPECT_NEAR(motion.q()[0], std::cos(until), 1e-13);
  }
}

TEST(Motion, PeriodsAreCountedApartFromTheirRest) {
  const System system = support::forced_oscillator(1.0, 0.1, 5.0, 0.8, 3.0, 1.0);
  Motion<double> motion(system, {}, Vector::Zero(1), Vector::Zero(1));
  for (long long period = 1; period <= 100; ++period) {
    motion.fly(0.5);
    motion.fly(motion.flow().period());
    EXPECT_EQ(motion.instant().period, period);
    EXPECT_EQ(motion.instant().local, 0.0);
  }
}

// Cutting a flight anywhere must not change it, in particular just after an impact.
TEST(Motion, CutFlightsMeetTheSameContacts) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Dice dice(seed);
    const System system = support::random_system(dice, 1 + dice.pick(3), dice.uniform(0.05, 0.3));
    const Vector rest = Vector::Zero(system.modes());
    Motion<double> whole(system, {}, rest, rest), cut(system, {}, rest, rest);
    const double period = whole.flow().period();
    const Arrival<double> first = whole.fly(period);
    Arrival<double> met;
    for (int i = 1; i <= 40 && met.kind == ArrivalKind::kTime; ++i)
      met = cut.fly(i == 40 ? period : period * i / 40.0);
    ASSERT_EQ(met.kind, first.kind) << "seed " << seed;
    if (first.kind != ArrivalKind::kContact) continue;
    EXPECT_NEAR(cut.instant().local, whole.instant().local, 1e-12) << "seed " << seed;
    EXPECT_NEAR(met.speed, first.speed, 1e-12) << "seed " << seed;
  }
}

// Motion from rest over many arcs, in double and in fifty digits, as long as no impact is slow.
TEST(Motion, ImpactsAgreeWithFiftyDigits) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Dice dice(500 + seed);
    const System system = support::forced_oscillator(
        dice.uniform(0.7, 1.5), dice.uniform(0.02, 0.1), dice.uniform(0.1, 0.4),
        dice.uniform(0.5, 0.9), dice.uniform(1.5, 3.0), 1.0);
    const Vector rest = Vector::Zero(1);
    Motion<double> motion(system, {}, rest, rest);
    Motion<Extended> precise(system, {}, rest.cast<Extended>(), rest.cast<Extended>());
    for (int arc = 0; arc < 30; ++arc) {
      const Arrival<double> arrival = motion.fly(motion.flow().period());
      const Arrival<Extended> expected = precise.fly(precise.flow().period());
      ASSERT_EQ(arrival.kind, expected.kind) << "seed " << seed << ", arc " << arc;
      if (arrival.kind == ArrivalKind::kStick) break;
      if (arrival.kind != ArrivalKind::kContact) continue;
      // A slow contact magnifies an error by 1/v; leave those runs there.
      if (arrival.speed < 0.05) break;
      ++compared;
      EXPECT_NEAR(motion.instant().local, static_cast<double>(precise.instant().local), 1e-10)
          << "seed " << seed << ", arc " << arc;
      EXPECT_NEAR(arrival.speed, static_cast<double>(expected.speed), 1e-10);
      motion.impact();
      precise.impact();
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace graze
