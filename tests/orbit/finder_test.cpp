// What a simulation settles on, and the list of orbits of a scene.
#include "graze/orbit/search/finder.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/settled.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// x'' + .1 x' + x = cos(W t), r = .8: the oscillator of scene 04.
System fruit_fly(double frequency, double gap) {
  return support::forced_oscillator(1.0, 0.05, gap, 0.8, frequency, 1.0);
}

TEST(Settled, OnOneImpactPerPeriod) {
  const System system = assemble(support::reference_scene("orbits/sdof_1_6"));
  const SettledMotion settled = settle(system, support::rest(system));
  ASSERT_TRUE(settled.pattern) << settled.classification;
  EXPECT_EQ(settled.pattern->period, 1);
  EXPECT_EQ(settled.pattern->impacts(), 1);
  ASSERT_EQ(settled.points.size(), 1u);
  // tests/reference/closed_form_orbits.csv; repetitions agree to 1e-6.
  EXPECT_NEAR(settled.points[0].theta, 0.53869685675624971, 1e-5);
  EXPECT_NEAR(settled.points[0].before.qdot[0], 2.7587090268542805, 1e-5);
}

TEST(Settled, OnOneImpactInTwoPeriods) {
  const System system = fruit_fly(4.0, 0.0);
  const SettledMotion settled = settle(system, support::state_of({-1.0}, {0.0}));
  ASSERT_TRUE(settled.pattern) << settled.classification;
  EXPECT_EQ(settled.pattern->period, 2);
  ASSERT_EQ(settled.pattern->impacts(), 1);
  double nearest = 1.0;
  for (const ImpactPoint& exact : closed_form(system, 0, 2).form->solutions(0.0))
    nearest =
        std::min(nearest, std::abs(std::remainder(settled.points[0].theta - exact.theta, kTurn)) +
                              std::abs(settled.points[0].before.qdot[0] - exact.before.qdot[0]));
  EXPECT_LE(nearest, 1e-5);
}

TEST(Settled, OnADoubledOrbitWhereTheSimpleOneIsUnstable) {
  const System system = fruit_fly(2.7, 0.0);
  for (const ImpactPoint& exact : closed_form(system, 0, 1).form->solutions(0.0)) {
    const ShootingProblem problem({1, {0}}, motion_scale(system));
    EXPECT_EQ(make_orbit(system, problem, problem.pack(system, {exact})).stable, false);
  }
  const SettledMotion settled = settle(system, support::state_of({-1.0}, {0.0}));
  ASSERT_TRUE(settled.pattern) << settled.classification;
  EXPECT_EQ(settled.pattern->period, 2);
  ASSERT_EQ(settled.pattern->impacts(), 2);
  EXPECT_GT(std::abs(settled.points[0].before.qdot[0] - settled.points[1].before.qdot[0]), 1e-2);
  const ShootingProblem problem(*settled.pattern, motion_scale(system));
  const auto solution = newton(problem, system, problem.pack(system, settled.points));
  ASSERT_TRUE(solution);
  const Orbit orbit = make_orbit(system, problem, solution->x);
  EXPECT_EQ(orbit.stable, true);
  EXPECT_TRUE(orbit.admissible);
}

TEST(Settled, SaysWhenTheMotionComesToRest) {
  // Dropped onto a stop at zero gap by a load that the forcing never overcomes.
  System system = support::forced_oscillator(1.0, 0.0, 0.0, 0.5, 0.3, 0.5);
  system.modal().load = Vector::Constant(1, 1.0);
  const SettledMotion settled = settle(system, support::state_of({-0.5}, {0.0}));
  EXPECT_EQ(settled.kind, SettledKind::kAtRest);
  EXPECT_FALSE(settled.pattern);
  EXPECT_NE(settled.classification.find("stays on the stop"), std::string::npos)
      << settled.classification;
}

TEST(Settled, SaysWhenAMotionThatSticksNeverRepeats) {
  const Scene scene = support::shipped_scene("02_wagg_momentum");
  const System system = assemble(scene);
  const SettledMotion settled = settle(system, initial_state(scene, system));
  EXPECT_EQ(settled.kind, SettledKind::kNotPeriodic);
  EXPECT_TRUE(settled.sticks);
  EXPECT_FALSE(settled.pattern);
}

TEST(Settled, SaysWhenTheStopIsNeverMet) {
  const System system = fruit_fly(1.6, 100.0);
  EXPECT_FALSE(settle(system, support::rest(system)).pattern);
  EXPECT_NE(settle(system, support::rest(system)).classification.find("no stop"),
            std::string::npos);
}

FoundOrbits find(const System& system, bool keep_virtual, std::uint64_t seed = 1) {
  FinderOptions options;
  options.keep_virtual = keep_virtual;
  options.random_seed = seed;
  const State start{Vector::Constant(system.modes(), 0.0), Vector::Zero(system.modes())};
  return find_orbits(system, start, options);
}

TEST(Finder, ListsBothSolutionsOfTheClosedFormOnce) {
  for (const char* name : {"sdof_1_6", "beam_n2_40", "beam_n4_47", "three_modes_2_1"}) {
    SCOPED_TRACE(name);
    const System system = assemble(support::reference_scene(std::string("orbits/") + name));
    const FoundOrbits found = find(system, true);
    int simple = 0;
    for (const Orbit& orbit : found.orbits)
      simple += orbit.period == 1 && orbit.impacts.size() == 1;
    EXPECT_EQ(simple, 2);
    EXPECT_EQ(found.closed_form.converged, 2);
    EXPECT_GT(found.random.converged, 0);
    const double speed = motion_scale(system).length * system.forcing()->frequency;
    for (std::size_t i = 0; i < found.orbits.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(same_orbit(found.orbits[i], found.orbits[j], speed));
  }
}

TEST(Finder, IsDeterministic) {
  const System system = assemble(support::reference_scene("orbits/beam_n4_40"));
  const FoundOrbits a = find(system, true), b = find(system, true);
  ASSERT_EQ(a.orbits.size(), b.orbits.size());
  for (std::size_t i = 0; i < a.orbits.size(); ++i) {
    EXPECT_EQ(a.orbits[i].impacts[0].phase, b.orbits[i].impacts[0].phase);
    EXPECT_EQ(a.orbits[i].impacts[0].speed, b.orbits[i].impacts[0].speed);
    EXPECT_EQ(a.orbits[i].residual, b.orbits[i].residual);
  }
  EXPECT_EQ(a.random.converged, b.random.converged);
}

TEST(Finder, LeavesOutAndCountsWhatIsNoOrbit) {
  const System system = assemble(support::reference_scene("orbits/beam_n2_40"));
  const FoundOrbits all = find(system, true), listed = find(system, false);
  for (const Orbit& orbit : listed.orbits) EXPECT_TRUE(orbit.admissible);
  EXPECT_EQ(listed.orbits.size() + static_cast<std::size_t>(listed.inadmissible),
            all.orbits.size());
}

TEST(Finder, RandomGuessesAloneFindTheClosedForm) {
  const System system = assemble(support::reference_scene("orbits/beam_n4_40"));
  FinderOptions options;
  options.impacts = 1;
  options.from_closed_form = options.from_simulation = false;
  options.keep_virtual = true;
  const FoundOrbits found = find_orbits(system, support::rest(system), options);
  ASSERT_EQ(found.orbits.size(), 2u);
  // tests/reference/closed_form_orbits.csv, case beam_n4_40
  EXPECT_NEAR(found.orbits[0].impacts[0].phase, 1.3901932500224201, 1e-12);
  EXPECT_NEAR(found.orbits[1].impacts[0].phase, 3.0262335730754375, 1e-12);
}

// |kappa| of the closed form less a small part: the two solutions nearly meet, and between them the
// equations are nearly solved too.
TEST(Finder, ListsTwoSolutionsBesideAFold) {
  for (const char* name : {"sdof_1_6", "beam_n2_40", "beam_n4_40", "beam_n4_47"}) {
    for (const double distance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13}) {
      SCOPED_TRACE(testing::Message() << name << ", distance " << distance);
      System system = assemble(support::reference_scene(std::string("orbits/") + name));
      system.stops[0].gap = std::abs(closed_form(system, 0, 1).form->kappa) * (1.0 - distance);
      FinderOptions options;
      options.impacts = 1;
      options.keep_virtual = true;
      const FoundOrbits found = find_orbits(system, support::rest(system), options);
      ASSERT_EQ(found.orbits.size(), 2u);
      // Half the distance of their phases is the fold's square root, acos(1 - distance).
      const double apart = std::abs(std::remainder(
          found.orbits[0].impacts[0].phase - found.orbits[1].impacts[0].phase, kTurn));
      EXPECT_NEAR(apart, 2.0 * std::sqrt(2.0 * distance), 2e-8 + 1e-4 * std::sqrt(distance));
    }
  }
}

// x'' + x = cos(W t), r = 1: impacts at a crest of the forcing, phase 0 or pi, at speed
// -(gap -+ X) tan(p pi/W), X = 1/(1 - W^2) (closed_form_test.cpp).
System conservative(double frequency) {
  return support::forced_oscillator(1.0, 0.0, 0.2, 1.0, frequency, 1.0);
}

TEST(Finder, ListsOrbitsOfConservativeMotion) {
  FinderOptions options;
  options.impacts = 1;
  options.from_simulation = false;
  for (const bool closed_form_too : {true, false}) {
    options.from_closed_form = closed_form_too;
    options.period = 1;
    const FoundOrbits one = find_orbits(conservative(1.8), {}, options);
    ASSERT_EQ(one.orbits.size(), 1u) << one.tried;
    EXPECT_NEAR(std::sin(one.orbits[0].impacts[0].phase), 0.0, 1e-12);
    EXPECT_NEAR(one.orbits[0].impacts[0].speed,
                -(0.2 - 1.0 / (1.0 - 1.8 * 1.8)) * std::tan(0.5 * kTurn / 1.8), 1e-11);
    options.period = 2;
    const FoundOrbits two = find_orbits(conservative(3.2), {}, options);
    ASSERT_EQ(two.orbits.size(), 2u) << two.tried;
    for (const Orbit& orbit : two.orbits) {
      const double crest = std::cos(orbit.impacts[0].phase) / (1.0 - 3.2 * 3.2);
      EXPECT_NEAR(std::sin(orbit.impacts[0].phase), 0.0, 1e-12);
      EXPECT_NEAR(orbit.impacts[0].speed, -(0.2 - crest) * std::tan(kTurn / 3.2), 1e-11);
    }
  }
}

// Backwards in time the motion is one of the same oscillator, phases mirrored and impacts at the
// same speeds, so the list is its own mirror image. With three impacts, as with one, speeds do not
// follow from the phases.
TEST(Finder, ListsConservativeOrbitsOfThreeImpactsWithTheirReversals) {
  FinderOptions options;
  options.period = 5;
  options.impacts = 3;
  options.from_simulation = false;
  const FoundOrbits found = find_orbits(conservative(3.2), {}, options);
  EXPECT_GE(found.orbits.size(), 3u);
  for (const Orbit& orbit : found.orbits) {
    EXPECT_LE(orbit.residual, kShootingTolerance);
    Orbit reversed = orbit;
    std::reverse(reversed.impacts.begin(), reversed.impacts.end());
    for (OrbitImpact& impact : reversed.impacts) {
      const double turned = -(impact.phase + kTurn * impact.period_index);
      impact.period_index = static_cast<int>(std::floor(turned / kTurn));
      impact.phase = turned - kTurn * impact.period_index;
    }
    EXPECT_TRUE(std::any_of(found.orbits.begin(), found.orbits.end(), [&](const Orbit& other) {
      return same_orbit(reversed, other, 1.0);
    })) << orbit.impacts[0].phase;
  }
}

TEST(Finder, FindsTheDoubledOrbitFromTheSimulation) {
  const System system = fruit_fly(2.7, 0.0);
  FinderOptions options;
  options.keep_virtual = true;
  const FoundOrbits found = find_orbits(system, support::state_of({-1.0}, {0.0}), options);
  int doubled = 0;
  for (const Orbit& orbit : found.orbits) {
    doubled += orbit.period == 2 && orbit.impacts.size() == 2;
    if (orbit.impacts.size() == 1) {
      EXPECT_EQ(orbit.period, 1);
    }
    for (std::size_t i = 1; i < orbit.impacts.size(); ++i)
      EXPECT_LE(orbit.impacts[i - 1].period_index, orbit.impacts[i].period_index);
  }
  EXPECT_EQ(doubled, 1);
}

// What the motion settles on is no answer where orbits of another period were asked for, but named.
TEST(Finder, ListsNoOrbitOfAnotherPeriodThanAskedFor) {
  const System rigid = fruit_fly(2.7, 0.0);  // settles on a (2, 2) orbit
  const System soft = assemble(support::shipped_scene("12_spring_dashpot_oscillator"));
  for (const System* system : {&rigid, &soft}) {
    FinderOptions options;
    options.from_closed_form = options.from_random = false;
    const State start{Vector::Constant(1, system == &rigid ? -1.0 : 0.0), Vector::Zero(1)};
    const FoundOrbits any = find_orbits(*system, start, options);
    ASSERT_EQ(any.orbits.size(), 1U);
    const int settled = any.orbits.front().period;
    options.only_this_period = true;
    for (const int period : {1, 2, 3}) {
      options.period = period;
      const FoundOrbits found = find_orbits(*system, start, options);
      EXPECT_EQ(found.orbits.size(), period == settled ? 1U : 0U) << period;
      ASSERT_FALSE(found.notes.empty());
      EXPECT_NE(found.notes.back().find(fmt::format("settles on a ({}, ", settled)),
                std::string::npos)
          << found.notes.back();
    }
  }
}

// Asked for two periods, the finder starts from the simple orbit taken twice only where that is
// what the simulation does; it must not list a (1, 1) orbit as (2, 2).
TEST(Finder, ListsMinimalOrbitsOnly) {
  const System system = assemble(support::reference_scene("orbits/sdof_1_6"));
  for (const int period : {1, 2, 3}) {
    FinderOptions options;
    options.period = period;
    options.keep_virtual = true;
    const FoundOrbits found = find_orbits(system, support::rest(system), options);
    for (const Orbit& orbit : found.orbits) {
      if (orbit.impacts.size() < 2) continue;
      EXPECT_GT(std::abs(orbit.impacts[0].phase - orbit.impacts[1].phase) +
                    std::abs(orbit.impacts[0].speed - orbit.impacts[1].speed),
                1e-6);
    }
  }
}

}  // namespace
}  // namespace graze
