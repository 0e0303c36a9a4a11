// The search for orbits that stick: from guesses near and far, for minimal and unstable ones; what
// it says where there is none.
#include <gtest/gtest.h>

#include "graze/assembly/assembly.hpp"
#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/system/scale.hpp"
#include "orbit/settled_sticking_orbit.hpp"

namespace graze {
namespace {

// The state of an orbit at the start of a forcing period.
State at_period_start(const Found& found) {
  const MotionState<double>& section = found.orbit.section->states.front();
  RunState from;
  from.motion = section;
  from.streaks.resize(found.system.stops.size());
  from.closure_speed = found.orbit.section->closure_speed;
  from.started = true;
  return resume(found.system, from, support::for_periods(section.instant.period + 1)).final;
}

FollowedAnswer search_from(const Found& found, const State& guess, int period) {
  return followed_orbit(found.system, guess, period,
                        {found.orbit.section->closure_speed, 10'000'000, {}});
}

TEST(StickingOrbitSearch, IsFoundFromARoughGuess) {
  support::Dice dice(7);
  for (const Scene& scene : {sticking_case("rayl3"), sticking_case("gravity2"),
                             beam("momentum", 2, 24.0), beam("collocation", 3, 44.0)}) {
    SCOPED_TRACE(scene.title);
    const Found found = settled_orbit(scene);
    const State start = at_period_start(found);
    const MotionScale scale = motion_scale(found.system);
    for (const double off : {1e-6, 1e-4}) {
      State guess = start;
      for (Eigen::Index j = 0; j < guess.q.size(); ++j) {
        guess.q[j] += off * scale.displacement * dice.uniform(-1.0, 1.0);
        guess.qdot[j] += off * scale.velocity[j] * dice.uniform(-1.0, 1.0);
      }
      const FollowedAnswer answer = search_from(found, guess, found.orbit.period);
      ASSERT_TRUE(answer.orbit) << off << ": " << answer.why_not;
      EXPECT_LE(answer.orbit->residual, 1e-13);
      ASSERT_FALSE(answer.orbit->sticking.empty());
      EXPECT_LE(
          turned(answer.orbit->sticking.front().to.phase, found.orbit.sticking.front().to.phase),
          1e-11);
    }
  }
}

TEST(StickingOrbitSearch, IsListedWithItsShortestPeriod) {
  const Found one = settled_orbit(sticking_case("rayl3"));
  const FollowedAnswer again = search_from(one, at_period_start(one), 4);
  ASSERT_TRUE(again.orbit) << again.why_not;
  EXPECT_EQ(again.orbit->period, 1);
  EXPECT_EQ(again.orbit->impacts.size(), one.orbit.impacts.size());
  const Found two = settled_orbit(beam("momentum", 3, 24.0));
  EXPECT_EQ(two.orbit.period, 2);
  const FollowedAnswer twice = search_from(two, at_period_start(two), 4);
  ASSERT_TRUE(twice.orbit) << twice.why_not;
  EXPECT_EQ(twice.orbit->period, 2);
  ASSERT_FALSE(two.orbit.impacts.empty());
  EXPECT_EQ(two.orbit.impacts.front().period_index, 0);
  for (std::size_t i = 1; i < two.orbit.impacts.size(); ++i) {
    const OrbitImpact &a = two.orbit.impacts[i - 1], &b = two.orbit.impacts[i];
    EXPECT_LT(a.phase + kTurn * a.period_index, b.phase + kTurn * b.period_index);
    EXPECT_LT(b.period_index, 2);
  }
}

// One mode remembers nothing: every start that sticks is on the orbit one period later.
TEST(StickingOrbitSearch, OfOneModeForgetsEveryStart) {
  const Found found = settled_orbit(sticking_case("Z2c"));
  for (const double q : {0.15, 0.1, -0.05})
    for (const double qdot : {0.0, 0.02}) {
      const FollowedAnswer answer = search_from(found, support::state_of({q}, {qdot}), 2);
      ASSERT_TRUE(answer.orbit) << answer.why_not;
      EXPECT_EQ(answer.orbit->period, 1);
      EXPECT_EQ(answer.orbit->residual, 0.0);
      EXPECT_EQ(exact_zeros(*answer.orbit), 2);
      EXPECT_EQ(answer.orbit->stable, std::optional<bool>(true));
      ASSERT_EQ(answer.orbit->impacts.size(), found.orbit.impacts.size());
      for (std::size_t i = 0; i < found.orbit.impacts.size(); ++i)
        EXPECT_NEAR(answer.orbit->impacts[i].speed, found.orbit.impacts[i].speed, 1e-14);
    }
}

// Past its flip the orbit is still there, and no simulation shows it.
TEST(StickingOrbitSearch, ThatIsUnstableIsFoundFromItsNeighbour) {
  const Found stable = settled_orbit(beam("momentum", 2, 24.0));
  EXPECT_EQ(stable.orbit.stable, std::optional<bool>(true));
  Found unstable{assemble(beam("momentum", 2, 24.1)), {}};
  const FollowedAnswer answer =
      followed_orbit(unstable.system, at_period_start(stable), 1,
                     {stable.orbit.section->closure_speed, 10'000'000, {}});
  ASSERT_TRUE(answer.orbit) << answer.why_not;
  unstable.orbit = *answer.orbit;
  EXPECT_EQ(unstable.orbit.stable, std::optional<bool>(false));
  const std::vector<Eigenvalue> expected = differenced_multipliers(unstable);
  EXPECT_LT(expected.front().value.real(), -1.0);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_LE(std::abs(unstable.orbit.multipliers[i].value - expected[i].value), 1e-8) << i;
  const Found settled = settled_orbit(beam("momentum", 2, 24.1));
  EXPECT_GT(settled.orbit.period, 1);
}

// Leaving the stop after a release is no minimum of the gap, however it is rounded.
TEST(StickingOrbitSearch, ClearanceKnowsNothingOfTheReleaseItself) {
  for (const double frequency : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
    SCOPED_TRACE(frequency);
    const Found found = settled_orbit(sticking_case(
        "ratio3", {"forcing.frequency=" + std::to_string(frequency), "stop.restitution=0.2"}));
    EXPECT_GT(found.orbit.clearance.value_or(1.0), 1e-9);
    EXPECT_TRUE(found.orbit.admissible);
  }
}

// For pictures: one flight per impact, each from the stop to the stop, in order.
TEST(StickingOrbitSearch, HasACurveFromImpactToImpact) {
  for (const Scene& scene : {sticking_case("rayl3"), beam("momentum", 3, 24.0)}) {
    SCOPED_TRACE(scene.title);
    const Found found = settled_orbit(scene);
    const double gap = found.system.stops[0].gap;
    const auto flights = orbit_curve(found.system, found.orbit, {found.system.stops[0].row}, 100);
    ASSERT_EQ(flights.size(), found.orbit.impacts.size());
    for (std::size_t i = 0; i < flights.size(); ++i) {
      const OrbitImpact& impact = found.orbit.impacts[i];
      EXPECT_NEAR(flights[i].front().theta, impact.phase + kTurn * impact.period_index, 1e-9);
      EXPECT_NEAR(flights[i].front().displacement, gap, 1e-12);
      EXPECT_NEAR(flights[i].back().displacement, gap, 1e-12);
      const OrbitImpact& next = found.orbit.impacts[(i + 1) % flights.size()];
      EXPECT_NEAR(flights[i].back().velocity, next.speed, 1e-9);
      for (const CurveSample& sample : flights[i]) EXPECT_LE(sample.displacement, gap + 1e-12);
    }
  }
}

TEST(StickingOrbitSearch, SaysWhyThereIsNone) {
  SegmentOptions options;
  options.closure_speed = 1e-6;
  // Pressed onto its stop for ever.
  const System held = support::forced_oscillator(1.0, 0.0, -0.2, 0.7, 1.3, 0.1);
  const FollowedAnswer rest = followed_orbit(held, support::state_of({-0.2}, {0.0}), 1, options);
  EXPECT_FALSE(rest.orbit);
  EXPECT_NE(rest.why_not.find("without any impact"), std::string::npos) << rest.why_not;
  // Far from its stop.
  const System free = support::forced_oscillator(1.0, 0.1, 50.0, 0.7, 1.3, 0.1);
  const FollowedAnswer clear = followed_orbit(free, support::state_of({0.0}, {0.0}), 3, options);
  EXPECT_FALSE(clear.orbit);
  EXPECT_NE(clear.why_not.find("no stop is closed within 3"), std::string::npos) << clear.why_not;
  // Two equal oscillators, side by side, each with its stop: hit at the same instants.
  System pair = support::forced_oscillator(1.0, 0.0, 0.2, 0.2, 0.5, 1.0);
  pair.omega = Vector::Ones(2);
  pair.modal().delta = Vector::Zero(2);
  pair.modal().forcing->amplitude = Vector::Ones(2);
  pair.stops[0].row = pair.stops[0].impact().direction = Vector::Unit(2, 0);
  pair.stops.push_back(pair.stops[0]);
  pair.stops[1].row = pair.stops[1].impact().direction = Vector::Unit(2, 1);
  const FollowedAnswer both =
      followed_orbit(pair, support::state_of({0.2, 0.2}, {0.0, 0.0}), 1, options);
  EXPECT_FALSE(both.orbit);
  EXPECT_NE(both.why_not.find("one instant"), std::string::npos) << both.why_not;
}

}  // namespace
}  // namespace graze
