// Runs: where they end, what they count, what they hand out. Expected values: closed forms.
#include "graze/motion/simulation.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::for_impacts;
using support::for_periods;
using support::for_seconds;
using support::forced_oscillator;
using support::oscillator;
using support::record_run;
using support::RecordedRun;
using support::state_of;

TEST(Simulation, EndsExactlyAtItsDuration) {
  const System system = oscillator(3.0, 0.0, 10.0, 0.8);
  const RecordedRun run = record_run(system, state_of({1.0}, {0.0}), for_seconds(2.5));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
  EXPECT_TRUE(run.result.message.empty());
  EXPECT_EQ(run.result.end_time, 2.5);
  EXPECT_NEAR(run.result.final.q[0], std::cos(7.5), 1e-14);
  EXPECT_NEAR(run.result.final.qdot[0], -3.0 * std::sin(7.5), 1e-14);
}

TEST(Simulation, EndsExactlyAfterItsPeriods) {
  const System system = forced_oscillator(3.0, 0.0, 10.0, 0.8, 2.0, 1.0);
  const RecordedRun run = record_run(system, support::rest(system), for_periods(7));
  EXPECT_EQ(run.result.end_time, 7.0 * system.period());
  // From rest under cos(2 t): (cos 2t - cos 3t)/(9 - 4); t = 7 pi.
  EXPECT_NEAR(run.result.final.q[0], (1.0 + 1.0) / 5.0, 1e-14);
}

TEST(Simulation, EndsAtADurationThatIsNoWholeNumberOfPeriods) {
  const System system = forced_oscillator(3.0, 0.0, 10.0, 0.8, 2.0, 1.0);
  for (const double duration : {0.0, 1.0, 3.0, 3.14159, 10.0, 100.0}) {
    const RecordedRun run = record_run(system, support::rest(system), for_seconds(duration));
    EXPECT_NEAR(run.result.end_time, duration, 2.0 * 2.2e-16 * duration);
    EXPECT_NEAR(run.result.final.q[0], (std::cos(2.0 * duration) - std::cos(3.0 * duration)) / 5.0,
                1e-13);
  }
}

TEST(Simulation, SpendsItsBudgetOfImpacts) {
  const RecordedRun run =
      record_run(oscillator(1.0, 0.0, 0.5, 1.0), state_of({0.0}, {1.0}), for_impacts(25, 1e6));
  EXPECT_EQ(run.result.outcome, RunOutcome::kEventBudget);
  EXPECT_EQ(run.result.totals.impacts, 25);
  EXPECT_EQ(run.events.size(), 25u);
  EXPECT_NE(run.result.message.find("25 impacts"), std::string::npos) << run.result.message;
  EXPECT_EQ(run.result.end_time, run.events.back().time);
}

TEST(Simulation, SpendsItsBudgetOfTime) {
  SimulationOptions options = for_periods(1'000'000'000);
  options.stop.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(10);
  const System system = forced_oscillator(3.0, 0.01, 10.0, 0.8, 2.0, 1.0);
  const Simulation run = simulate(system, support::rest(system), options);
  EXPECT_EQ(run.outcome, RunOutcome::kTimeBudget);
  EXPECT_FALSE(run.message.empty());
}

TEST(Simulation, SaysWhenTheMotionLeavesTheRangeOfTheScalar) {
  const RecordedRun run =
      record_run(oscillator(1e3, 0.0, 1.0, 0.8), state_of({-1e307}, {0.0}), for_seconds(1.0));
  EXPECT_EQ(run.result.outcome, RunOutcome::kNotFinite);
  EXPECT_FALSE(run.result.message.empty());
}

TEST(Simulation, StopsWhenInterrupted) {
  std::atomic<bool> interrupted{true};
  SimulationOptions options = for_seconds(100.0);
  options.stop.interrupted = &interrupted;
  const System system = oscillator(1.0, 0.0, 0.5, 1.0);
  const Simulation at_once = simulate(system, state_of({0.0}, {1.0}), options);
  EXPECT_EQ(at_once.outcome, RunOutcome::kInterrupted);
  EXPECT_EQ(at_once.end_time, 0.0);

  interrupted = false;
  long long impacts = 0;
  RunListeners listeners;
  listeners.event = [&](const Event&) { interrupted = ++impacts == 3; };
  const Simulation later = simulate(system, state_of({0.0}, {1.0}), options, listeners);
  EXPECT_EQ(later.outcome, RunOutcome::kInterrupted);
  EXPECT_EQ(later.totals.impacts, 3);
}

// The oblique law makes the held structure grow (tests/flow/contact_phase_test.cpp): the run is
// refused at its start, and hands out no sample there, whether in one piece or resumed.
// A sample has its time whether or not those before it are handed out.
TEST(Simulation, SamplesBeginWhereTheyAreWanted) {
  System system{Vector::Constant(1, 2.0), NaturalModes{Vector::Zero(1)}, {}};
  SimulationOptions options;
  options.duration = 1.0;
  const auto samples_from = [&](double from) {
    std::vector<Sample> samples;
    RunListeners listeners;
    listeners.sample = [&](const Sample& sample) { samples.push_back(sample); };
    listeners.sample_rate = 10.0;
    listeners.sample_from = from;
    simulate(system, state_of({0.5}, {0.0}), options, listeners);
    return samples;
  };
  ASSERT_EQ(samples_from(0.0).size(), 11u);
  const std::vector<Sample> late = samples_from(0.75);
  ASSERT_EQ(late.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const Sample& sample = late[static_cast<std::size_t>(i)];
    EXPECT_EQ(sample.time, (8 + i) / 10.0);
    EXPECT_NEAR(sample.state.q[0], 0.5 * std::cos(2.0 * sample.time), 1e-14);
  }
  EXPECT_TRUE(samples_from(7.0).empty());
}

TEST(Simulation, ARefusedStartHasNoSamplesHoweverOftenItIsResumed) {
  System system{Eigen::Vector2d(3.0, 1.0), NaturalModes{Vector::Zero(2)}, {}};
  const Vector row = Eigen::Vector2d(1.0, 1.0);
  system.stops.push_back({row, -1.0, ImpactLaw{Eigen::Vector2d(1.25, -0.25), 0.5}});
  // At rest on the stop: free acceleration into it -(b.w^2 q) = 9.
  const State start = state_of({-1.0, 0.0}, {0.0, 0.0});
  int samples = 0;
  RunListeners listeners;
  listeners.sample = [&samples](const Sample&) { ++samples; };
  listeners.sample_rate = 10.0;
  Simulation run = simulate(system, start, for_seconds(1.0), listeners);
  EXPECT_EQ(run.outcome, RunOutcome::kRefused);
  run = resume(system, run.state, for_seconds(1.0), listeners);
  EXPECT_EQ(run.outcome, RunOutcome::kRefused);
  EXPECT_EQ(samples, 0);
}

// Two stops at one place, one with r = 0: the one that holds the structure keeps the other closed,
// and both are left together. The mass never gets beyond either.
TEST(Simulation, StopsAtOnePlaceAreLeftTogether) {
  System system = forced_oscillator(63.0, 0.0, 0.0, 0.0, 91.0, 72.0);
  system.modal().forcing->phase = 0.94;
  system.stops[0].row[0] = system.stops[0].impact().direction[0] = -1.0;
  system.stops.push_back(system.stops[0]);
  system.stops[1].impact().restitution = Restitution(0.7364336049948917);
  system.stops.push_back({Vector::Ones(1), 0.0006, ImpactLaw{Vector::Ones(1), 0.78}});
  SimulationOptions options = for_periods(50);
  RunListeners listeners;
  double beyond = 0.0;
  long long samples = 0;
  listeners.sample = [&](const Sample& sample) {
    beyond = std::max({beyond, -sample.state.q[0], sample.state.q[0] - 0.0006});
    ++samples;
  };
  listeners.sample_rate = 1000.0;
  const Simulation run = simulate(system, support::rest(system), options, listeners);
  EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
  EXPECT_GT(samples, 3000);
  EXPECT_LE(beyond, 1e-15);
}

// A mode far slower than its forcing, hardly damped: its free part lasts for 1/delta = 1000 s.
TEST(Simulation, EnergyBalanceOfASoftModeCloses) {
  const System system = forced_oscillator(0.9, 0.001, 1e3, 0.5, 79.0, 1200.0);
  SimulationOptions options = for_periods(10);
  options.energy = true;
  const Simulation run = simulate(system, support::rest(system), options);
  // The mass swings at 1200/79 m/s, and is back at rest after whole periods.
  const double swing = 0.5 * (1200.0 / 79.0) * (1200.0 / 79.0);
  EXPECT_LE(std::abs(run.energy->defect()), 1e-13 * swing);
}

// Held by a stop that sees another mode, a mode glides to its place of rest on a stop of gap zero
// and gets ever nearer. Unequal damping and w = delta leave no modes to the held structure; the
// quick one makes the norms that bound its motion large.
TEST(Simulation, AGlideOntoAStopBesideAQuickMotionIsFollowed) {
  System system{Eigen::Vector4d(178.0, 154.0, 4070.0, 98.0), NaturalModes{Vector::Zero(4)}, {}};
  system.modal().delta << 178.0, 28.0, 0.0, 25.0;
  system.stops.push_back({-Vector::Unit(4, 1), -0.007, ImpactLaw{-Vector::Unit(4, 1), 0.0}});
  system.stops.push_back({-Vector::Unit(4, 0), 0.0, ImpactLaw{-Vector::Unit(4, 0), 0.0}});
  const RecordedRun run = record_run(
      system, state_of({0.006, 0.007, -5e-5, 0.09}, {0.2, 0.0, -0.04, 2.5}), for_seconds(0.4));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_EQ(run.result.stuck.front(), 0);
  // Critical damping: (q0 + (q0' + w q0) t) e^{-w t}.
  const double t = 0.4, w = 178.0;
  EXPECT_NEAR(run.result.final.q[0], (0.006 + (0.2 + w * 0.006) * t) * std::exp(-w * t), 1e-15);
}

TEST(Simulation, InelasticImpactRestsWherePushedAndLeavesWherePulled) {
  // The spring pulls the mass off a stop beyond its place of rest, ...
  const RecordedRun pulled =
      record_run(oscillator(1.0, 0.0, 0.5, 0.0), state_of({0.0}, {1.0}), for_seconds(3.0));
  EXPECT_EQ(pulled.result.outcome, RunOutcome::kReachedEnd);
  ASSERT_EQ(pulled.events.size(), 1u);
  const double contact = std::asin(0.5);
  EXPECT_NEAR(pulled.events[0].time, contact, 1e-15);
  EXPECT_NEAR(pulled.result.final.q[0], 0.5 * std::cos(3.0 - contact), 1e-14);
  // ... and pushes it against one before it.
  const RecordedRun pushed =
      record_run(oscillator(1.0, 0.0, -0.5, 0.0), state_of({-1.0}, {0.0}), for_seconds(3.0));
  EXPECT_EQ(pushed.result.outcome, RunOutcome::kReachedEnd);
  EXPECT_EQ(pushed.result.stuck, std::vector<int>{0});
  ASSERT_EQ(pushed.events.size(), 2u);
  EXPECT_EQ(pushed.events[1].kind, EventKind::kStick);
  EXPECT_EQ(pushed.events[1].time, pushed.events[0].time);
  EXPECT_NEAR(pushed.events[0].time, std::acos(0.5), 1e-14);
  EXPECT_EQ(pushed.result.final.q[0], -0.5);
  EXPECT_NEAR(pushed.result.forces[0], 0.5, 1e-16);
  EXPECT_NEAR(pushed.result.totals.stuck_time, 3.0 - std::acos(0.5), 1e-14);
}

// Into a corner whose first wall takes all of the speed towards it, and whose second throws back:
// on the first the structure is at rest (v- = 0) when it is thrown back onto it, and stays.
TEST(Simulation, AWallThatTakesAllSpeedDoesNotStopTheMotionAlongIt) {
  System system{Vector::Zero(2), NaturalModes{Vector::Zero(2)}, {}};
  const Vector first{{1.0, 0.0}}, second{{-0.6, 0.8}};
  system.stops.push_back({first, 0.0, ImpactLaw{momentum_direction(first), Restitution(0.0)}});
  system.stops.push_back({second, 0.0, ImpactLaw{momentum_direction(second), Restitution(0.7)}});
  const RecordedRun run = record_run(system, state_of({0.0, 0.0}, {1.0, 0.5}), for_seconds(1.0));
  // (1, 0.5) -> (0, 0.5), v2 = 0.4 -> q2' = -0.7 * 0.4/0.8.
  EXPECT_NEAR(run.result.final.qdot[0], 0.0, 1e-15);
  EXPECT_NEAR(run.result.final.qdot[1], -0.35, 1e-15);
  EXPECT_NEAR(run.result.totals.energy_lost, 0.625 - 0.5 * 0.35 * 0.35, 1e-15);
}

TEST(Simulation, ForceDecidesAtAStopAtThePlaceOfRest) {
  // r = 0, a = 0: at contact only the force acts. sin-like approach meets it with cos(W t) of
  // either sign, chosen by the phase.
  for (const double phase : {0.0, std::numbers::pi}) {
    System system = forced_oscillator(1.0, 0.0, 0.0, 0.0, 0.1, 0.01);
    system.modal().forcing->phase = phase;
    const RecordedRun run = record_run(system, state_of({0.0}, {1.0}), for_seconds(1.0));
    ASSERT_GE(run.events.size(), 1u);
    EXPECT_EQ(run.events[0].time, 0.0);
    EXPECT_EQ(run.events.size() > 1 && run.events[1].kind == EventKind::kStick, phase == 0.0);
  }
}

TEST(Simulation, CountsTimeOverManyPeriods) {
  // The one impact per period of a stable orbit, 200 000 periods long.
  const System system = assemble(support::reference_scene("orbits/sdof_1_6"));
  const RecordedRun run = record_run(system, support::rest(system), for_periods(200'000));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
  EXPECT_EQ(run.result.end_time, 200'000.0 * system.period());
  ASSERT_GT(run.events.size(), 199'000u);
  for (std::size_t i = run.events.size() - 1000; i < run.events.size(); ++i) {
    const Event& event = run.events[i];
    // tests/reference/closed_form_orbits.csv
    EXPECT_NEAR(*event.phase, 0.53869685675624971, 1e-11);
    EXPECT_NEAR(event.speed, 2.7587090268542805, 1e-11);
    EXPECT_EQ(event.period_index, run.events[i - 1].period_index + 1);
    const double time =
        static_cast<double>(event.period_index) * system.period() + *event.phase / 1.6;
    EXPECT_NEAR(event.time / time, 1.0, 1e-15);
  }
}

TEST(Simulation, PhaseFollowsTheForcing) {
  System system = forced_oscillator(1.0, 0.05, 0.5, 0.8, 1.6, 1.0);
  for (const double phase : {-7.0, 0.0, 2.0, 30.0}) {
    system.modal().forcing->phase = phase;
    const RecordedRun run = record_run(system, support::rest(system), for_periods(20));
    ASSERT_FALSE(run.events.empty());
    for (const Event& event : run.events) {
      EXPECT_GE(*event.phase, 0.0);
      EXPECT_LT(*event.phase, 2.0 * std::numbers::pi);
      EXPECT_NEAR(std::remainder(*event.phase - (1.6 * event.time + phase), 2.0 * std::numbers::pi),
                  0.0, 1e-13 * (1.0 + 1.6 * event.time));
    }
  }
}

struct Samples {
  std::vector<Sample> list;
  RunListeners listeners(double rate) {
    RunListeners listeners;
    listeners.sample_rate = rate;
    listeners.sample = [this](const Sample& sample) { list.push_back(sample); };
    return listeners;
  }
};

TEST(Simulation, SamplesStandAtMultiplesOfTheirInterval) {
  Samples samples;
  // |sin t| against a stop at zero: bounces every pi, elastic.
  simulate(oscillator(1.0, 0.0, 0.0, 1.0), state_of({0.0}, {-1.0}), for_seconds(20.0),
           samples.listeners(50.0));
  ASSERT_EQ(samples.list.size(), 1001u);
  for (std::size_t i = 0; i < samples.list.size(); ++i) {
    const double t = static_cast<double>(i) / 50.0;
    EXPECT_EQ(samples.list[i].time, t);
    EXPECT_NEAR(samples.list[i].state.q[0], -std::abs(std::sin(t)), 1e-14 * (1.0 + t)) << t;
  }
}

TEST(Simulation, SamplesOfAForcedRunIncludeItsEnd) {
  const System system = forced_oscillator(3.0, 0.0, 10.0, 0.8, 28.3, 1.0);
  for (const double duration : {1.0, 2.0, 5.0, 10.0}) {
    Samples samples;
    simulate(system, support::rest(system), for_seconds(duration), samples.listeners(100.0));
    EXPECT_EQ(samples.list.size(), static_cast<std::size_t>(100.0 * duration) + 1) << duration;
    for (const Sample& sample : samples.list) {
      const double t = sample.time, norm = 9.0 - 28.3 * 28.3;
      EXPECT_NEAR(sample.state.q[0], (std::cos(28.3 * t) - std::cos(3.0 * t)) / norm, 1e-15);
    }
  }
}

TEST(Simulation, SmallestGapWithoutImpactsIsTheAnalyticMinimum) {
  // From rest: (cos 2t - cos 3t)/5; its crests satisfy 3 sin 3t = 2 sin 2t.
  const System system = forced_oscillator(3.0, 0.0, 10.0, 0.8, 2.0, 1.0);
  double highest = 0.0;
  for (int i = 0; i <= 2'000'000; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 2'000'000.0;
    highest = std::max(highest, (std::cos(2.0 * t) - std::cos(3.0 * t)) / 5.0);
  }
  const RecordedRun run = record_run(system, support::rest(system), for_periods(4));
  EXPECT_TRUE(run.events.empty());
  ASSERT_TRUE(run.result.totals.smallest_gap);
  // The samples' distance h hides at most 13/5 h^2/8.
  EXPECT_NEAR(*run.result.totals.smallest_gap, 10.0 - highest, 1e-11);
}

TEST(Simulation, SmallestGapOfAnImpactingRunIsZeroToRounding) {
  const Scene scene = support::shipped_scene("01_wagg_2004");
  const System system = assemble(scene);
  const RecordedRun run = record_run(system, initial_state(scene, system), for_seconds(2.0));
  ASSERT_TRUE(run.result.totals.smallest_gap);
  EXPECT_NEAR(*run.result.totals.smallest_gap, 0.0, 1e-17);
}

TEST(Simulation, WithoutStopsThereIsNoGap) {
  System system = forced_oscillator(3.0, 0.1, 10.0, 0.8, 2.0, 1.0);
  system.stops.clear();
  const RecordedRun run = record_run(system, support::rest(system), for_periods(3));
  EXPECT_FALSE(run.result.totals.smallest_gap);
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
}

TEST(Simulation, TellsItsProgressOncePerPeriod) {
  std::vector<double> fractions;
  RunListeners listeners;
  listeners.progress = [&](double fraction) { fractions.push_back(fraction); };
  const System system = forced_oscillator(3.0, 0.1, 10.0, 0.8, 2.0, 1.0);
  simulate(system, support::rest(system), for_periods(8), listeners);
  ASSERT_EQ(fractions.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(fractions[i], static_cast<double>(i + 1) / 8.0, 1e-15);
}

// 13 equal stops, all hit at once, do what one of them does.
TEST(Simulation, ThirteenStopsAtOnePlaceAreOne) {
  System system = support::oscillator(0.0, 0.0, 1.0, 0.8);
  for (int k = 1; k < 13; ++k) system.stops.push_back(system.stops[0]);
  const RecordedRun run =
      record_run(system, support::state_of({0.0}, {1.0}), support::for_seconds(3.0));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_NEAR(run.result.final.qdot[0], -0.8, 1e-15);
  EXPECT_NEAR(run.result.final.q[0], 1.0 - 0.8 * 2.0, 1e-14);
}

// 13 masses above stops at different depths come to rest one after the other.
TEST(Simulation, ThirteenMassesRestOnTheirStops) {
  constexpr int kMasses = 13;
  constexpr double kGravity = 9.81;
  System system{Vector::Zero(kMasses), NaturalModes{Vector::Zero(kMasses)}, {}};
  system.modal().load = Vector::Constant(kMasses, kGravity);
  for (int k = 0; k < kMasses; ++k) {
    const Vector row = Vector::Unit(kMasses, k);
    system.stops.push_back({row, 0.1 * (k + 1), ImpactLaw{row, Restitution(0.0)}});
  }
  const Simulation run =
      simulate(system, {Vector::Zero(kMasses), Vector::Zero(kMasses)}, for_seconds(3.0), {});
  EXPECT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
  EXPECT_NEAR(*run.totals.smallest_gap, 0.0, 1e-15);
  for (std::size_t k = 0; k < kMasses; ++k) EXPECT_NEAR(run.forces[k], kGravity, 1e-12) << k;
}

}  // namespace
}  // namespace graze
