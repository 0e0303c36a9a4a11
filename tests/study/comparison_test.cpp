// Motions compared: against closed forms of free motions and of one impact a period, and maps
// against single comparisons.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/base/errors.hpp"
#include "graze/study/compare/comparison_map.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// x'' + 0.1 x' + x = F cos(Omega t) before a stop, r = 0.8.
Scene oscillator(const std::vector<std::string>& settings) {
  return support::shipped_scene("04_impact_oscillator", settings);
}

ComparedMotion motion(const Scene& scene, const CompareOptions& options = {}) {
  const std::optional<ComparedMotion> result = compared_motion(scene, options);
  EXPECT_TRUE(result.has_value());
  return result.value_or(ComparedMotion{});
}

// Twice the force moves a linear structure twice as far.
TEST(Comparison, OfFreeMotionsAsTheLinearResponseSays) {
  const auto at = [](const std::string& amplitude) {
    return motion(oscillator({"stop.gap=10", "initial.q=[0.0]", "forcing.amplitude=" + amplitude}));
  };
  const ComparedMotion one = at("1"), other = at("2");
  const double square = 1.0 / (std::pow(1.0 - 2.8 * 2.8, 2) + std::pow(0.1 * 2.8, 2));
  ASSERT_TRUE(one.energy && other.energy);
  // (A^2 Omega^2 + A^2)/4
  EXPECT_NEAR(*one.energy, 0.25 * square * (2.8 * 2.8 + 1.0), 1e-8 * *one.energy);
  EXPECT_EQ(one.taken, 0.0);
  EXPECT_EQ(one.attractor.kind, SettledKind::kClear);
  const MotionDifference apart = difference(one, other, {});
  EXPECT_TRUE(apart.is_same_attractor);
  EXPECT_EQ(apart.first, 0);
  EXPECT_FALSE(apart.first_time);
  EXPECT_NEAR(apart.displacement.value(), 0.5, 1e-7);
  EXPECT_NEAR(apart.velocity.value(), 0.5, 1e-7);
  EXPECT_NEAR(apart.energy.value(), 0.75, 1e-7);
  EXPECT_EQ(apart.taken, 0.0);
}

// An impact at speed v takes (1 - r^2) v^2/2 of a unit mass.
TEST(Comparison, TellsWhatTheStopTakes) {
  for (const double restitution : {0.5, 0.8}) {
    const Scene scene =
        oscillator({"forcing.frequency=2", "stop.restitution=" + std::to_string(restitution)});
    CompareOptions options;
    const ComparedMotion one = motion(scene, options);
    ASSERT_EQ(one.attractor.kind, SettledKind::kImpacts);
    ASSERT_EQ(one.attractor.impacts, one.attractor.period);
    // What settles is handed on from period to period; its last impacts are those of the orbit.
    options.first = 400;
    const ComparedMotion longer = motion(scene, options);
    double taken = 0.0;
    for (int k = 0; k < one.attractor.impacts; ++k) {
      const double speed =
          longer.first[longer.first.size() - 1 - static_cast<std::size_t>(k)].speed;
      taken += 0.5 * (1.0 - restitution * restitution) * speed * speed;
    }
    EXPECT_NEAR(one.taken.value(), taken / one.attractor.period, 1e-6 * taken);
  }
}

// Up to the first impact restitution plays no part.
TEST(Comparison, SeesTheFirstImpactsPart) {
  CompareOptions options;
  options.first = 12;
  const Scene hard = oscillator({"stop.restitution=0.8"}),
              soft = oscillator({"stop.restitution=0.7"});
  const ComparedMotion one = motion(hard, options), other = motion(soft, options);
  EXPECT_EQ(one.first.size(), 12u);
  const MotionDifference apart = difference(one, other, options);
  EXPECT_EQ(apart.first, 12);
  EXPECT_EQ(apart.first_time, 0.0);
  EXPECT_EQ(apart.first_speed, 0.0);
  EXPECT_EQ(apart.agreeing, 1);
  options.within = 10.0;
  EXPECT_EQ(difference(one, other, options).agreeing, 12);
}

TEST(Comparison, FindsNothingBetweenAMotionAndItself) {
  const ComparedMotion one = motion(oscillator({"forcing.frequency=2"}));
  const MotionDifference none = difference(one, one, {});
  EXPECT_EQ(none.agreeing, 20);
  EXPECT_TRUE(none.is_same_attractor);
  for (const auto& part : {none.first_time, none.first_speed, none.displacement, none.velocity,
                           none.energy, none.taken})
    EXPECT_EQ(part, 0.0);
}

// The same orbit of two periods, seen one period later: in the period in which they differ least,
// they do not.
TEST(Comparison, SeesOrbitsInWhicheverPeriodTheyAreAlike) {
  bool two_periods = false;
  for (const char* frequency : {"2.4", "2.5", "2.6", "2.7"}) {
    const std::string at = std::string("forcing.frequency=") + frequency;
    const ComparedMotion one = motion(oscillator({at}));
    if (one.attractor.period != 2) continue;
    two_periods = true;
    ComparedMotion other = one;
    const std::size_t half = one.displacement.size() / 2;
    std::rotate(other.displacement.begin(), other.displacement.begin() + half,
                other.displacement.end());
    std::rotate(other.velocity.begin(), other.velocity.begin() + half, other.velocity.end());
    const MotionDifference apart = difference(one, other, {});
    EXPECT_EQ(apart.displacement, 0.0);
    EXPECT_EQ(apart.velocity, 0.0);
    other.displacement.resize(half);
    EXPECT_FALSE(difference(one, other, {}).displacement);
  }
  EXPECT_TRUE(two_periods);
}

TEST(ComparisonMap, HasTheDifferencesOfItsCells) {
  const Scene one = oscillator({"initial.q=[0.0]", "initial.qdot=[0.0]"});
  const Scene other = oscillator({"initial.q=[0.0]", "initial.qdot=[0.0]", "stop.restitution=0.6"});
  ComparisonMapOptions options;
  options.x = {"forcing.frequency", 1.6, 3.2, 5};
  options.y = {"stop.gap", -0.1, 0.3, 3};
  const ComparisonMap map = compare_over(one, other, options);
  ASSERT_EQ(map.cells.size(), 15u);
  options.threads = 1;
  const ComparisonMap alone = compare_over(one, other, options);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const ComparedCell& cell = map.cells[i];
    EXPECT_TRUE(cell.is_known);
    // A start beyond the stop.
    EXPECT_EQ(cell.one.status == SweepStatus::kNoStart, i < 5) << cell.message;
    if (i < 5) {
      EXPECT_NE(cell.message, "");
    }
    EXPECT_EQ(cell.difference.energy, alone.cells[i].difference.energy);
    if (i < 5) continue;
    const MotionDifference single =
        difference(motion(scene_at(one, options, i)), motion(scene_at(other, options, i)), options);
    EXPECT_EQ(cell.difference.energy, single.energy);
    EXPECT_EQ(cell.difference.displacement, single.displacement);
    EXPECT_EQ(cell.difference.agreeing, single.agreeing);
  }
  // Only the other one starts beyond the stop.
  const Scene beyond = oscillator({"initial.q=[0.2]", "initial.qdot=[0.0]"});
  options.y = {"stop.gap", 0.1, 0.4, 2};
  const ComparisonMap mixed = compare_over(one, beyond, options);
  EXPECT_NE(mixed.cells[0].one.status, SweepStatus::kNoStart);
  EXPECT_EQ(mixed.cells[0].other.status, SweepStatus::kNoStart);
  EXPECT_NE(mixed.cells[0].message, "");
  EXPECT_NE(mixed.cells[5].other.status, SweepStatus::kNoStart);
  // What --against changes must not be what the plane sets.
  EXPECT_THROW(
      compare_over(one, oscillator({"initial.q=[0.0]", "initial.qdot=[0.0]", "stop.gap=0.7"}),
                   options),
      InputError);
  options.y = {"stop.gap", 0.1, 0.1, 2};
  EXPECT_THROW(compare_over(one, other, options), InputError);
  options.y.name = "stop.gape";
  EXPECT_THROW(compare_over(one, other, options), InputError);
}

}  // namespace
}  // namespace graze
