// When a motion counts as settled: near its orbit by the closed form, not only slow.
#include "graze/orbit/search/settled.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/scene/reader.hpp"
#include "graze/system/scale.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

SettleOptions as_near_as(double nearness, long long periods = 20000) {
  SettleOptions options;
  options.periods = periods;
  options.nearness = nearness;
  return options;
}

double distance(const MetImpact& impact, const ImpactPoint& exact) {
  return std::max(std::abs(std::remainder(impact.phase - exact.theta, kTurn)),
                  std::abs(impact.speed / exact.before.qdot[0] - 1.0));
}

// The state of an orbit half a period after its impact, from where a period is made to start: an
// impact at the very start of a period would be counted now to this, now to that one.
State half_way(System& system, const ImpactPoint& exact) {
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const State after = after_impact(system.stops[0], exact.before);
  arc.start(exact.theta, after.q, after.qdot);
  State state{Vector(system.modes()), Vector(system.modes())};
  arc.state(0.5 * flow.period(), state.q, state.qdot);
  system.modal().forcing->phase = exact.theta + 0.5 * kTurn;
  return state;
}

// x'' + .1 x' + x = F cos(1.6 t), r = .8, just inside the fold |kappa| = gap, where the largest
// multiplier of the stable orbit is 1 - O(sqrt(1 - gap/|kappa|)).
TEST(Settled, ASlowApproachIsFollowedToItsEnd) {
  for (const double inside : {1e-2, 1e-3, 1e-4, 1e-5}) {
    SCOPED_TRACE(inside);
    System system = support::forced_oscillator(1.0, 0.05, 0.5, 0.8, 1.6, 1.0);
    system.stops[0].gap = std::abs(closed_form(system, 0, 1).form->kappa) * (1.0 - inside);
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    for (const ImpactPoint& exact :
         closed_form(system, 0, 1).form->solutions(system.stops[0].gap)) {
      const Orbit orbit = make_orbit(system, problem, problem.pack(system, {exact}));
      if (orbit.stable != true || !orbit.admissible) continue;
      const double slowest = std::abs(orbit.multipliers.front().value);
      State start = half_way(system, exact);
      start.qdot *= 1.0 + 1e-3 * inside;
      const SettledMotion settled = settle(system, start, as_near_as(1e-8));
      ASSERT_EQ(settled.kind, SettledKind::kImpacts) << settled.classification;
      EXPECT_TRUE(settled.near);
      EXPECT_LT(settled.remaining, 1e-8);
      ASSERT_EQ(settled.impacts.size(), 1u);
      const double off = distance(settled.impacts[0], exact);
      EXPECT_LE(off, 1e-8) << "multiplier " << slowest;
      // A test of differences alone would have stopped at 1e-8/(1 - multiplier).
      if (inside <= 1e-4) {
        EXPECT_GT(slowest, 0.97);
      }
    }
  }
}

TEST(Settled, NearnessIsTheDistanceThatIsLeft) {
  const System system = support::forced_oscillator(1.0, 0.05, 0.0, 0.8, 1.6, 1.0);
  for (const double nearness : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const SettledMotion settled =
        settle(system, support::state_of({-1.0}, {0.0}), as_near_as(nearness));
    ASSERT_TRUE(settled.near) << nearness;
    double least = 1.0;
    for (const ImpactPoint& exact : closed_form(system, 0, 1).form->solutions(0.0))
      least = std::min(least, distance(settled.impacts[0], exact));
    EXPECT_LE(least, std::max(nearness, 1e-13));
  }
}

// A motion that starts beside a stable orbit with a multiplier near -1.
struct NearFlip {
  double frequency = 0.0;
  ImpactPoint exact;
  Orbit orbit;
  System system;  // its phase shifted
  State start;
};

std::vector<NearFlip> motions_near_flip() {
  std::vector<NearFlip> motions;
  for (double frequency = 2.60; frequency < 2.66; frequency += 0.004) {
    const System system = support::forced_oscillator(1.0, 0.05, 0.0, 0.8, frequency, 1.0);
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    for (const ImpactPoint& exact : closed_form(system, 0, 1).form->solutions(0.0)) {
      const Orbit orbit = make_orbit(system, problem, problem.pack(system, {exact}));
      if (orbit.stable != true || !orbit.admissible) continue;
      System shifted = system;
      State start = half_way(shifted, exact);
      start.qdot *= 1.0 + 1e-4;
      motions.push_back({frequency, exact, orbit, shifted, start});
    }
  }
  return motions;
}

// Multipliers near -1: after two periods the motion seems to repeat long before it does after one.
TEST(Settled, AnOrbitSeenTwiceIsOne) {
  for (const NearFlip& motion : motions_near_flip()) {
    const SettledMotion settled = settle(motion.system, motion.start, as_near_as(1e-8));
    SCOPED_TRACE(testing::Message()
                 << motion.frequency << ": " << motion.orbit.multipliers.front().value);
    EXPECT_TRUE(settled.near);
    EXPECT_EQ(settled.period, 1);
    ASSERT_EQ(settled.impacts.size(), 1u);
    EXPECT_LE(distance(settled.impacts[0], motion.exact), 1e-8);
  }
}

// On an unstable orbit to the last bit: differences are roundings and stay so for a while, which
// must not pass for settled. Left alone it ends on the doubled orbit.
TEST(Settled, AnUnstableOrbitIsNoPlaceToSettle) {
  System system = support::forced_oscillator(1.0, 0.05, 0.0, 0.8, 2.7, 1.0);
  const ShootingProblem problem({1, {0}}, motion_scale(system));
  int met = 0;
  for (const ImpactPoint& exact : closed_form(system, 0, 1).form->solutions(0.0)) {
    const Orbit orbit = make_orbit(system, problem, problem.pack(system, {exact}));
    if (!orbit.admissible) continue;
    ++met;
    EXPECT_EQ(orbit.stable, false);
    System shifted = system;
    const State start = half_way(shifted, exact);
    EXPECT_FALSE(settle(shifted, start, as_near_as(1e-8, 60)).near);
    const SettledMotion end = settle(shifted, start, as_near_as(1e-8));
    EXPECT_TRUE(end.near);
    EXPECT_EQ(end.period, 2);
    EXPECT_EQ(end.impacts.size(), 2u);
  }
  EXPECT_GE(met, 1);
}

TEST(Settled, SaysSoWhenThePeriodsDoNotSuffice) {
  const System system = support::forced_oscillator(1.0, 0.05, 0.0, 0.8, 1.6, 1.0);
  const SettledMotion settled =
      settle(system, support::state_of({-1.0}, {0.0}), as_near_as(1e-300, 60));
  EXPECT_EQ(settled.kind, SettledKind::kImpacts);
  EXPECT_EQ(settled.periods, 60);
  EXPECT_FALSE(settled.near);
  EXPECT_GE(settled.remaining, 1e-300);
  EXPECT_NE(
      settled.classification.find("settles on 1 impact that repeats every forcing period, but"),
      std::string::npos)
      << settled.classification;
}

// The doubled orbit of the last test but two, with a budget that ends now in its first period, now
// in its second: the motion has come to it within rounding either way.
TEST(Settled, WhatIsLeftDoesNotDependOnWhereTheBudgetEnds) {
  const System system = support::forced_oscillator(1.0, 0.05, 0.0, 0.8, 2.7, 1.0);
  const State start = support::state_of({-1.0}, {0.0});
  ASSERT_EQ(settle(system, start, as_near_as(1e-8)).period, 2);
  for (long long periods = 900; periods < 904; ++periods) {
    const SettledMotion settled = settle(system, start, as_near_as(1e-300, periods));
    SCOPED_TRACE(periods);
    EXPECT_FALSE(settled.near);
    EXPECT_EQ(settled.period, 2);
    EXPECT_EQ(settled.impacts.size(), 2u);
    EXPECT_LE(settled.remaining, 1e-11);
  }
}

// Multipliers near -1, and a budget that is spent when two periods agree to 1e-6 and one does not.
TEST(Settled, AnOrbitSeenTwiceIsOneOnTheWayThere) {
  int seen_twice = 0;
  for (const NearFlip& motion : motions_near_flip()) {
    const long long enough = settle(motion.system, motion.start, as_near_as(1e-8)).periods;
    for (long long periods = enough - 8; periods < enough; ++periods) {
      const SettledMotion settled = settle(motion.system, motion.start, as_near_as(1e-8, periods));
      SCOPED_TRACE(testing::Message() << motion.frequency << ", " << periods << " of " << enough);
      if (settled.period == 0) continue;
      EXPECT_FALSE(settled.near);
      EXPECT_EQ(settled.period, 1);
      EXPECT_EQ(settled.impacts.size(), 1u);
      EXPECT_GE(settled.remaining, 1e-8);
      EXPECT_LE(settled.remaining, 1e-3);
      ++seen_twice;
    }
  }
  EXPECT_GE(seen_twice, 16);
}

// Free of the stop the motion tends to Re(P e^{i Omega t}); decay e^{-.005 * 2 pi} a period, so
// 1e-8 by waiting would take six hundred of them.
TEST(Settled, ClearMotionEndsOnItsSteadyResponse) {
  const System system = support::forced_oscillator(1.0, 0.005, 2.0, 0.8, 2.0, 1.0);
  const SettledMotion settled =
      settle(system, support::state_of({0.1}, {0.2}), as_near_as(1e-8, 1000));
  ASSERT_EQ(settled.kind, SettledKind::kClear) << settled.classification;
  EXPECT_TRUE(settled.near);
  EXPECT_EQ(settled.periods, 1);
  // P = 1/(1 - 4 + 2 i 0.005 2)
  const Complex response = 1.0 / Complex(-3.0, 0.02);
  EXPECT_NEAR(settled.at_end.q[0], response.real(), 1e-15);
  EXPECT_NEAR(settled.at_end.qdot[0], -2.0 * response.imag(), 1e-15);
}

// The same, but beating into the stop first: the steady amplitude 1/3 clears it, the start does
// not.
TEST(Settled, ABeatThatReachesTheStopIsNotClear) {
  const System system = support::forced_oscillator(1.0, 0.005, 0.4, 0.8, 2.0, 1.0);
  const SettledMotion settled =
      settle(system, support::state_of({0.3}, {0.5}), as_near_as(1e-8, 1000));
  ASSERT_EQ(settled.kind, SettledKind::kClear) << settled.classification;
  EXPECT_GT(settled.impacts_met, 0);
  EXPECT_GT(settled.periods, 1);
}

// x'' + x = cos(W t), x <= s: sticks once a period and is released where cos(W t) = s. W = .3, s =
// .1, r = .8, first impact after the release at v = .548917278001831 (tests/hard, Z2).
TEST(Settled, FollowsChatterAndSticking) {
  const System system = support::forced_oscillator(1.0, 0.0, 0.1, 0.8, 0.3, 1.0);
  SettleOptions options = as_near_as(1e-8, 200);
  const SettledMotion settled = settle(system, support::state_of({0.1}, {0.0}), options);
  ASSERT_EQ(settled.kind, SettledKind::kSticks) << settled.classification;
  EXPECT_EQ(settled.period, 1);
  EXPECT_TRUE(settled.near);
  EXPECT_TRUE(settled.sticks);
  EXPECT_FALSE(settled.pattern);
  const double release = std::acos(0.1);
  const MetImpact* first = nullptr;
  for (const MetImpact& impact : settled.impacts)
    if (impact.phase > release && (!first || impact.phase < first->phase)) first = &impact;
  ASSERT_NE(first, nullptr);
  EXPECT_NEAR(first->speed, 0.548917278001831, 1e-9);
  EXPECT_NEAR(first->phase, 0.3 * 16.723521925366774, 1e-9);
}

// Four modes, chatter, sticking: the impacts are those of a simulation. (It cuts the arc at the end
// of a closed chatter and this does not; roundings grow by some tens a period.)
TEST(Settled, FollowsTheMotionOfASimulation) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SettleOptions options = as_near_as(0.0, 6);
  const SettledMotion settled = settle(system, start, options);
  const support::RecordedRun run = support::record_run(system, start, support::for_periods(6));
  EXPECT_GT(run.result.totals.chatters, 0);
  EXPECT_TRUE(settled.sticks);
  ASSERT_EQ(settled.impacts_met, run.result.totals.impacts);
  std::size_t i = 0;
  for (const Event& event : run.events) {
    if (event.kind != EventKind::kImpact) continue;
    const MetImpact& met = settled.impacts[i++];
    EXPECT_EQ(met.period, event.period_index);
    EXPECT_NEAR(wrapped(met.phase), *event.phase, 1e-8);
    EXPECT_NEAR(met.speed, event.speed, 1e-8);
  }
  EXPECT_EQ(i, settled.impacts.size());
  EXPECT_LE((settled.at_end.q - run.result.final.q).norm(), 1e-8);
}

// A forcing period holds 250 oscillations: a flight is cut within it.
TEST(Settled, FollowsTheMotionOfASimulationThroughLongPeriods) {
  const System system = support::forced_oscillator(1.0, 0.01, 0.3, 0.8, 0.004, 0.5);
  const State start = support::state_of({0.2}, {0.0});
  SettleOptions options;
  options.periods = 3;
  options.nearness = 0.0;
  const SettledMotion settled = settle(system, start, options);
  SimulationOptions simulated;
  simulated.periods = 3;
  const Simulation run = simulate(system, start, simulated);
  EXPECT_EQ(settled.impacts_met, run.totals.impacts);
  EXPECT_LE((settled.at_end.q - run.final.q).norm(), 1e-12);
}

// The paper's beam with many modes meets its stop in bursts of thousands of impacts in one period,
// which end. Only the budget that is asked for cuts them.
TEST(Settled, BurstsThatEndAreFollowed) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/05_wagg_one_mode.toml",
                                 {"beam.modes=64", "forcing.frequency=39.5556"});
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SettleOptions options = as_near_as(0.0, 40);
  const SettledMotion settled = settle(system, start, options);
  EXPECT_EQ(settled.kind, SettledKind::kNotPeriodic);
  EXPECT_EQ(settled.periods, 40);
  options.max_impacts = 1000;
  const SettledMotion cut = settle(system, start, options);
  EXPECT_EQ(cut.kind, SettledKind::kImpactBudget);
  EXPECT_EQ(cut.impacts_met, 1000);
}

}  // namespace
}  // namespace graze
