// What the motion settles on over a parameter: against the closed form, and the same however many
// threads share the work.
#include "graze/study/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "graze/system/scale.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

SystemFamily family_of(const std::string& scene, const std::string& parameter,
                       const std::vector<std::string>& settings = {}) {
  return SystemFamily(read_scene(GRAZE_SOURCE_DIR "/data/scenes/" + scene + ".toml", settings),
                      parameter);
}

SweepOptions over(double from, double to, int points,
                  SweepDirection direction = SweepDirection::kUp) {
  SweepOptions options;
  options.from = from;
  options.to = to;
  options.points = points;
  options.direction = direction;
  options.threads = 2;
  return options;
}

// x'' + .1 x' + x = F cos(1.6 t), stop at .5, r = .8: the oscillator of G2.
SystemFamily bistable_family() {
  return family_of("04_impact_oscillator", "forcing.amplitude",
                   {"forcing.frequency=1.6", "stop.gap=0.5", "initial.q=[0.0]"});
}

// Distance of a row with one impact in p periods from the nearest stable orbit of the closed form:
// phase in rad, speed relative.
double distance_from_closed_form(const SystemFamily& family, const SweepRow& row) {
  const System system = *family.at(row.value);
  const MetImpact& impact = row.motion.impacts.front();
  const ClosedFormAnswer answer = closed_form(system, impact.stop, row.motion.period);
  double least = 1.0;
  const ShootingProblem problem({row.motion.period, {impact.stop}}, motion_scale(system));
  for (const ImpactPoint& exact : answer.form->solutions(system.stops[0].gap)) {
    const Orbit orbit = make_orbit(system, problem, problem.pack(system, {exact}));
    if (orbit.stable != true || !orbit.admissible) continue;
    const double speed = system.stops[0].row.dot(exact.before.qdot);
    const double phase = std::abs(std::remainder(impact.phase - exact.theta, kTurn));
    least = std::min(least, std::max(phase, std::abs(impact.speed / speed - 1.0)));
  }
  return least;
}

// Every row with one impact in p periods lies on a stable branch; how many there are.
int check_against_closed_form(const SystemFamily& family, const SweepOptions& options) {
  int simple = 0;
  for (const SweepRow& row : sweep(family, options).rows) {
    if (row.motion.kind != SettledKind::kImpacts || row.motion.impacts.size() != 1) continue;
    if (row.status != SweepStatus::kSettled) continue;
    ++simple;
    EXPECT_LE(distance_from_closed_form(family, row), 1e-8) << row.value;
  }
  return simple;
}

TEST(Sweep, LiesOnTheStableBranchesOfThePaperBeam) {
  const SystemFamily family = family_of("05_wagg_one_mode", "forcing.frequency");
  EXPECT_GE(check_against_closed_form(family, over(15.0, 120.0, 421)), 150);
  EXPECT_GE(check_against_closed_form(family, over(15.0, 120.0, 211, SweepDirection::kFresh)), 70);
}

TEST(Sweep, LiesOnTheStableBranchesOverOtherParameters) {
  const auto at_40 = [](const char* parameter) {
    return family_of("05_wagg_one_mode", parameter, {"forcing.frequency=40"});
  };
  EXPECT_GE(check_against_closed_form(at_40("stop.gap"), over(0.0, 5e-3, 60)), 20);
  EXPECT_GE(check_against_closed_form(at_40("stop.restitution"), over(0.5, 0.9, 60)), 20);
  EXPECT_GE(check_against_closed_form(at_40("damping.viscous"), over(0.001, 0.1, 60)), 20);
  EXPECT_GE(check_against_closed_form(at_40("forcing.amplitude"), over(3e-4, 1e-3, 60)), 20);
}

// Wherever the closed form has a stable admissible orbit and no rival is in sight, it is found.
// F_g = .5 sqrt((1 - W^2)^2 + (.1 W)^2) = .784091831356506353; fold at F/F_g = .352831175746127748
// (50 digits, tests/hard, G2).
TEST(Sweep, KeepsToItsAttractorInEitherDirection) {
  const double grazing = 0.784091831356506353, fold = 0.352831175746127748 * grazing;
  const SystemFamily family = bistable_family();
  const Sweep up = sweep(family, over(0.2, 1.0, 161));
  const Sweep down = sweep(family, over(0.2, 1.0, 161, SweepDirection::kDown));
  ASSERT_EQ(up.rows.size(), 161u);
  ASSERT_EQ(down.rows.size(), 161u);
  int two = 0;
  for (std::size_t i = 0; i < 161; ++i) {
    const SweepRow &u = up.rows[i], &d = down.rows[i];
    EXPECT_EQ(u.value, d.value);
    SCOPED_TRACE(u.value);
    EXPECT_EQ(u.motion.kind == SettledKind::kClear, u.value < grazing);
    EXPECT_EQ(d.motion.kind == SettledKind::kClear, d.value < fold);
    if (d.value < fold) continue;
    ASSERT_EQ(d.motion.kind, SettledKind::kImpacts);
    ASSERT_EQ(d.motion.impacts.size(), 1u);
    EXPECT_LE(distance_from_closed_form(family, d), 1e-8);
    two += d.value < grazing;
  }
  EXPECT_GE(two, 90);
}

// From rest the motion either beats into the stop or not; whatever it does, the value before has no
// say in it.
TEST(Sweep, FreshStartsKnowNothingOfEachOther) {
  const SystemFamily family = bistable_family();
  const Sweep all = sweep(family, over(0.2, 1.0, 33, SweepDirection::kFresh));
  for (const std::size_t i : {0u, 7u, 16u, 32u}) {
    const SweepRow& row = all.rows[i];
    const Sweep alone = sweep(family, over(row.value, row.value + 1.0, 2, SweepDirection::kFresh));
    EXPECT_EQ(alone.rows[0].motion.at_end.q, row.motion.at_end.q);
    EXPECT_EQ(alone.rows[0].motion.periods, row.motion.periods);
    EXPECT_EQ(row.start, SweepStart::kScene);
  }
}

template <class Value>
void add_bytes(const Value& value, std::string& text) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// All that rows hold of their motions, to the last bit.
std::string motions(const std::vector<SweepRow>& rows) {
  std::string text;
  const auto add = [&](const auto& value) { add_bytes(value, text); };
  for (const SweepRow& row : rows) {
    add(row.value);
    add(row.status);
    add(row.start);
    add(row.motion.period);
    add(row.motion.remaining);
    add(row.motion.periods);
    add(row.motion.impacts_met);
    for (const MetImpact& impact : row.motion.impacts) {
      add(impact.phase);
      add(impact.speed);
    }
    text += row.message;
  }
  return text;
}

// All that a sweep holds.
std::string bytes(const Sweep& result) {
  std::string text = motions(result.rows);
  for (const SweepRow& row : result.rows)
    for (const auto& state : row.stop_states) {
      add_bytes(state.displacement, text);
      add_bytes(state.velocity, text);
    }
  add_bytes(result.periods, text);
  add_bytes(result.run_again, text);
  return text;
}

TEST(Sweep, IsTheSameForAnyNumberOfThreads) {
  for (const SweepDirection direction :
       {SweepDirection::kUp, SweepDirection::kDown, SweepDirection::kFresh}) {
    SweepOptions options = over(22.0, 60.0, 90, direction);
    options.periods = 120;
    const SystemFamily family = family_of("05_wagg_one_mode", "forcing.frequency");
    options.threads = 1;
    const std::string one = bytes(sweep(family, options));
    for (const int threads : {2, 5}) {
      options.threads = threads;
      EXPECT_EQ(bytes(sweep(family, options)), one);
    }
  }
}

// Cut into blocks or in one go, the sweep is on the same attractors: the bistable oscillator again,
// with starts from rest that fall on either.
TEST(Sweep, JoinsItsBlocksIntoOneSweep) {
  const SystemFamily family = bistable_family();
  for (const SweepDirection direction : {SweepDirection::kUp, SweepDirection::kDown}) {
    const Sweep blocks = sweep(family, over(0.2, 1.0, 81, direction));
    int handed_on = 0;
    for (const SweepRow& row : blocks.rows) handed_on += row.start == SweepStart::kHandedOn;
    EXPECT_EQ(handed_on, 80);
    // Falling from 1 the orbit with impacts is kept where a start from rest would not find it.
    if (direction == SweepDirection::kDown) {
      EXPECT_GT(blocks.run_again, 81 / Sweep::kBlock);
    }
  }
}

// The same, all in order: blocks that each start from the scene's initial state, then each joined
// to the last row of the one before.
std::string joined_in_order(const SystemFamily& family, const SweepOptions& options) {
  std::vector<SweepRow> rows(static_cast<std::size_t>(options.points));
  const bool falls = options.direction == SweepDirection::kDown;
  const auto run = [&](std::size_t k, const SweepRow* before) {
    SweepRow row;
    row.value = sweep_value(options, static_cast<int>(falls ? rows.size() - 1 - k : k));
    if (before) row.start = SweepStart::kHandedOn;
    const Scene scene = with_parameter(family.scene(), family.parameter(), row.value);
    const System system = assemble(scene);
    EXPECT_TRUE(settle_row(scene, system,
                           before ? before->motion.at_end : initial_state(scene, system), options,
                           row));
    return row;
  };
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = run(k, k % Sweep::kBlock == 0 ? nullptr : &rows[k - 1]);
  for (std::size_t first = Sweep::kBlock; first < rows.size(); first += Sweep::kBlock)
    for (std::size_t k = first; k < std::min(first + Sweep::kBlock, rows.size()); ++k) {
      SweepRow again = run(k, &rows[k - 1]);
      const bool is_same =
          attractor_class(again) == attractor_class(rows[k]) &&
          (again.status != SweepStatus::kSettled ||
           are_same_period_states(motion_scale(*family.at(again.value)), again.motion.period_states,
                                  rows[k].motion.period_states, 16.0 * options.nearness));
      rows[k] = std::move(again);
      if (is_same) break;
    }
  if (falls) std::reverse(rows.begin(), rows.end());
  return motions(rows);
}

TEST(Sweep, IsThatOfBlocksJoinedInOrder) {
  for (const SweepDirection direction : {SweepDirection::kUp, SweepDirection::kDown}) {
    const SweepOptions bistable = over(0.2, 1.0, 81, direction);
    EXPECT_EQ(motions(sweep(bistable_family(), bistable).rows),
              joined_in_order(bistable_family(), bistable));
    SweepOptions wild = over(22.0, 60.0, 90, direction);
    wild.periods = 120;
    const SystemFamily family = family_of("05_wagg_one_mode", "forcing.frequency");
    EXPECT_EQ(motions(sweep(family, wild).rows), joined_in_order(family, wild));
  }
}

TEST(Sweep, StartsAnewWhereTheStopHasMovedPastTheState) {
  // The mass rests on a preloaded stop (08: at rest for ever as long as F <= |gap|); the stop moves
  // against it.
  const SystemFamily family =
      family_of("08_preloaded_oscillator", "stop.gap", {"forcing.amplitude=0.1"});
  const Sweep moved = sweep(family, over(-0.2, -0.4, 5, SweepDirection::kDown));
  ASSERT_EQ(moved.rows.size(), 5u);
  EXPECT_EQ(moved.rows[0].start, SweepStart::kScene);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(moved.rows[i].motion.kind, SettledKind::kAtRest);
    EXPECT_EQ(moved.rows[i].status, SweepStatus::kSettled);
    EXPECT_NEAR(moved.rows[i].stop_states.front().displacement, moved.rows[i].value, 1e-15);
    if (i > 0) {
      EXPECT_EQ(moved.rows[i].start, SweepStart::kAnew);
    }
  }
}

// x'' + .1 x' + x = F cos(.5 t) on a stop at -.2: at rest for ever as long as F <= .2, else lifted
// off once a period and back.
TEST(Sweep, TellsRestFromSticking) {
  const SystemFamily family = family_of("08_preloaded_oscillator", "forcing.amplitude");
  for (const SweepRow& row : sweep(family, over(0.1, 0.31, 22, SweepDirection::kFresh)).rows) {
    SCOPED_TRACE(row.value);
    EXPECT_EQ(row.motion.kind, row.value <= 0.2 ? SettledKind::kAtRest : SettledKind::kSticks);
    EXPECT_EQ(row.status, SweepStatus::kSettled);
    EXPECT_EQ(row.motion.period, 1);
    EXPECT_TRUE(row.motion.sticks);
  }
}

TEST(Sweep, ADoubledOrbitIsOne) {
  // tests/orbit: at 2.7 both simple orbits are unstable and a (2, 2) orbit is stable.
  const SystemFamily family = family_of("04_impact_oscillator", "forcing.frequency");
  const Sweep result = sweep(family, over(2.69, 2.71, 3));
  for (const SweepRow& row : result.rows) {
    EXPECT_EQ(row.status, SweepStatus::kSettled);
    EXPECT_EQ(row.motion.period, 2);
    EXPECT_EQ(row.motion.impacts.size(), 2u);
  }
  EXPECT_EQ(attractor_ranges(result.rows).size(), 1u);
}

TEST(Sweep, ASpentBudgetIsARowAndTheSweepGoesOn) {
  const SystemFamily family = bistable_family();
  SweepOptions options = over(0.2, 1.0, 41);
  options.max_impacts = 3;
  const Sweep result = sweep(family, options);
  ASSERT_EQ(result.rows.size(), 41u);
  EXPECT_EQ(result.stopped, StopReason::kNone);
  int spent = 0;
  for (const SweepRow& row : result.rows) {
    spent += row.status == SweepStatus::kImpactBudget;
    EXPECT_LE(row.motion.impacts_met, 3);
    EXPECT_EQ(row.status == SweepStatus::kImpactBudget, !row.message.empty());
  }
  // Beyond the grazing there is nothing but impacts.
  EXPECT_GE(spent, 10);
  EXPECT_EQ(result.rows.front().motion.kind, SettledKind::kClear);
}

TEST(Sweep, AValueWithoutAStartIsARow) {
  // The scene starts at q = -1: no place for it behind a stop at less than that.
  const SystemFamily family = family_of("04_impact_oscillator", "stop.gap");
  const Sweep result = sweep(family, over(-1.5, 0.5, 5, SweepDirection::kFresh));
  ASSERT_EQ(result.rows.size(), 5u);
  EXPECT_EQ(result.rows[0].status, SweepStatus::kNoStart);
  EXPECT_FALSE(result.rows[0].message.empty());
  EXPECT_NE(result.rows[4].status, SweepStatus::kNoStart);
}

TEST(Sweep, KeepsFinishedRowsInOrderWhenInterrupted) {
  std::atomic<bool> stop{false};
  SweepOptions options = over(20.0, 60.0, 200);
  options.stop.interrupted = &stop;
  options.progress = [&](double fraction) { stop = stop || fraction > 0.3; };
  const Sweep result = sweep(family_of("05_wagg_one_mode", "forcing.frequency"), options);
  EXPECT_EQ(result.stopped, StopReason::kInterrupted);
  EXPECT_GE(result.rows.size(), 60u);
  EXPECT_LT(result.rows.size(), 200u);
  for (std::size_t i = 1; i < result.rows.size(); ++i)
    EXPECT_LT(result.rows[i - 1].value, result.rows[i].value);
}

TEST(Sweep, RunsAllPeriodsWhenAskedTo) {
  SweepOptions options = over(20.0, 60.0, 20);
  options.nearness = 0.0;
  options.periods = 150;
  const Sweep result = sweep(family_of("05_wagg_one_mode", "forcing.frequency"), options);
  for (const SweepRow& row : result.rows) EXPECT_EQ(row.motion.periods, 150);
}

TEST(Sweep, ValuesReachBothEndsExactly) {
  const SweepOptions options = over(0.1, 0.7, 7);
  EXPECT_EQ(sweep_value(options, 0), 0.1);
  EXPECT_EQ(sweep_value(options, 6), 0.7);
}

// Beside equal arms of the hub a mode has another sign: what is handed on is where the masses are.
TEST(Sweep, HandsOnDisplacementsOfMasses) {
  const SystemFamily family(support::reference_scene("lumped/hub", {"damping.ratio=0.05"}),
                            "lumped.masses.2");
  const System from = *family.at(1.0 - 1e-6), to = *family.at(1.0 + 1e-6);
  ASSERT_GT((*to.coordinates() - *from.coordinates()).norm(), 1.0);
  const State end = support::state_of({0.004, -0.02, 0.01}, {0.3, 0.1, -0.2});
  const State start = handed_on(from, to, end);
  EXPECT_LT((*to.coordinates() * start.q - *from.coordinates() * end.q).norm(), 1e-15);
  EXPECT_LT((*to.coordinates() * start.qdot - *from.coordinates() * end.qdot).norm(), 1e-14);
}

}  // namespace
}  // namespace graze
