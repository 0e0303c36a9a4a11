// Branches of orbits that stick: chatters that complete at their release against a bisection in 60
// digits, points against what simulations settle on.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "branch_checks.hpp"
#include "graze/base/angle.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/scene/parameter.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::number;
using support::special_points;
using support::sticking_branches;
using support::TableRow;

Scene oscillator(const TableRow& row) {
  return support::reference_scene(
      "sticking/Z2b",
      {"modal.damping_ratios=[" + row.at("zeta") + "]", "forcing.frequency=" + row.at("frequency"),
       "stop.gap=" + row.at("gap"), "stop.restitution=" + row.at("restitution"),
       "initial.q=[" + row.at("gap") + "]"});
}

// ---------------------------------------------------------------- CH of oscillators

TEST(StickingBranch, EndsWhereTheChatterCompletesAtItsRelease) {
  for (const TableRow& row : support::read_table("chatter_points.csv")) {
    SCOPED_TRACE(row.at("case"));
    const double critical = number(row, "critical");
    const double own = *find_parameter(oscillator(row), row.at("parameter"));
    const OrbitBranches result =
        sticking_branches(oscillator(row), row.at("parameter"),
                          {.from = 0.8 * own, .to = 1.02 * critical, .start_values = 0});
    ASSERT_EQ(result.branches.size(), 1u);
    const OrbitBranch& branch = result.branches[0];
    EXPECT_EQ(branch.sticking, std::vector<int>{0});
    EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kParameterLimit);
    EXPECT_EQ(branch.ends[1], OrbitBranchEnd::kChatterCompletes);
    ASSERT_EQ(branch.special.size(), 1u);
    const SpecialPoint& ch = branch.special[0];
    EXPECT_EQ(ch.id, "CH1");
    EXPECT_FALSE(ch.interrupted);
    EXPECT_LE(std::abs(ch.at.value / critical - 1.0), 1e-10);
    EXPECT_EQ(ch.at.value, branch.points.back().value);
    // What is left of the stuck phase, and of the contact force that sets in.
    const StickingPhase& last = ch.at.orbit.sticking.front();
    const System system = *SystemFamily(oscillator(row), row.at("parameter")).at(ch.at.value);
    EXPECT_LE(last.duration, 1e-6 * system.period());
    EXPECT_LE(last.force, 1e-6);
    for (const OrbitBranchPoint& point : branch.points) {
      ASSERT_TRUE(point.orbit.sticks());
      EXPECT_TRUE(point.orbit.admissible);
      EXPECT_EQ(point.orbit.stable, true);
      EXPECT_EQ(point.unstable_multipliers, 0);
      ASSERT_EQ(point.orbit.multipliers.size(), 2u);
      for (const Eigenvalue& m : point.orbit.multipliers) EXPECT_EQ(m.value, Complex(0.0));
      // Released where the push ends: cos(phase) = gap.
      const StickingPhase& sticking = point.orbit.sticking.front();
      const double gap =
          SystemFamily(oscillator(row), row.at("parameter")).at(point.value)->stops[0].gap;
      EXPECT_NEAR(sticking.to.phase, std::acos(gap), 1e-10);
    }
  }
}

// However its tail is summed.
TEST(StickingBranch, ChatterPointDoesNotDependOnTheClosureSpeed) {
  const TableRow row = support::read_table("chatter_points.csv")[1];
  for (const double speed : {1e-3, 1e-5, 1e-9}) {
    BranchOptions options{.from = 0.1, .to = 0.9, .start_values = 0};
    options.finder.closure_speed = speed;
    const OrbitBranches result =
        support::trace_from_runs(oscillator(row), row.at("parameter"), options);
    const auto found = special_points(result, SpecialKind::kChatterCompletes);
    ASSERT_EQ(found.size(), 1u) << speed;
    EXPECT_LE(std::abs(found[0]->at.value / number(row, "critical") - 1.0), 1e-10) << speed;
  }
}

// Whether a run from the release of an oscillator sticks within one forcing period.
bool sticks_after_release(const System& system) {
  const HarmonicForcing& forcing = *system.forcing();
  const double release = std::acos(system.stops[0].gap / forcing.amplitude[0]) - forcing.phase;
  // The rest of the period in which the push ends, and the next one up to its own end.
  MotionState<double> start;
  start.instant.local = (release < 0.0 ? release + kTurn : release) / forcing.frequency;
  start.q = Vector::Constant(1, system.stops[0].gap);
  start.qdot = Vector::Zero(1);
  start.contacts = {Contact::kDeparting};
  start.multiplicities = {3};
  RunState from;
  from.motion = start;
  from.streaks.resize(1);
  from.started = true;
  from.closure_speed = 1e-8;
  bool sticks = false;
  RunListeners listeners;
  listeners.event = [&](const Event& event) { sticks = sticks || event.kind == EventKind::kStick; };
  SimulationOptions options;
  options.duration = start.instant.local + system.period();
  resume(system, from, options, listeners);
  return sticks;
}

TEST(StickingBranch, ChatterPointPartsRunsThatStickFromRunsThatDoNot) {
  for (const TableRow& row : support::read_table("chatter_points.csv")) {
    SCOPED_TRACE(row.at("case"));
    const SystemFamily family(oscillator(row), row.at("parameter"));
    const OrbitBranches result = sticking_branches(
        oscillator(row), row.at("parameter"),
        {.from = 0.8 * family.value(), .to = 1.02 * number(row, "critical"), .start_values = 0});
    const auto found = special_points(result, SpecialKind::kChatterCompletes);
    ASSERT_EQ(found.size(), 1u);
    for (const double aside : {1e-9, 1e-6, 1e-3}) {
      EXPECT_TRUE(sticks_after_release(*family.at(found[0]->at.value * (1.0 - aside)))) << aside;
      EXPECT_FALSE(sticks_after_release(*family.at(found[0]->at.value * (1.0 + aside)))) << aside;
    }
  }
}

// ---------------------------------------------------------------- several modes

// The state at the section after some periods of a run from it, its velocities pushed.
State pushed_run(const System& system, const Orbit& orbit, double push, int rounds) {
  const OrbitSection& section = *orbit.section;
  RunState from;
  from.motion = section.states.front();
  from.motion.qdot *= 1.0 + push;  // still b.q' = 0
  from.streaks.resize(system.stops.size());
  from.closure_speed = section.closure_speed;
  from.started = true;
  from.motion.instant.period = 0;
  SimulationOptions options;
  options.duration = from.motion.instant.local + rounds * orbit.period * system.period();
  return resume(system, from, options).final;
}

// Stable orbits are returned to by a run that starts beside them, unstable ones are left.
int expect_stability_of_runs(const Scene& scene, const std::string& parameter,
                             const OrbitBranches& result) {
  const SystemFamily family(scene, parameter);
  int seen = 0;
  for (const OrbitBranch& branch : result.branches)
    for (std::size_t i = 0; i < branch.points.size(); i += 6) {
      const OrbitBranchPoint& point = branch.points[i];
      SCOPED_TRACE(testing::Message() << "branch " << branch.id << " at " << point.value);
      const double largest = std::abs(point.orbit.multipliers.front().value);
      if (largest > 0.8 && largest < 1.25) continue;
      // Beside a grazing the basin is as narrow as the way to it.
      if (largest > 20.0 || point.orbit.clearance.value_or(1.0) < 1e-3) continue;
      const System system = *family.at(point.value);
      const State at{point.orbit.section->states.front().q,
                     point.orbit.section->states.front().qdot};
      const double size = at.qdot.norm();
      const auto miss = [&](int rounds) {
        return (pushed_run(system, point.orbit, 1e-6, rounds).qdot - at.qdot).norm() / size;
      };
      if (largest < 1.0)
        EXPECT_LE(miss(80), 1e-9);
      else
        EXPECT_GE(miss(80), 1e-5);
      ++seen;
    }
  return seen;
}

TEST(StickingBranch, OfSeveralModesAreReturnedToByRunsOrLeft) {
  const Scene scene = support::reference_scene("sticking/rayl3");
  EXPECT_GE(
      expect_stability_of_runs(scene, "forcing.frequency",
                               sticking_branches(scene, "forcing.frequency",
                                                 {.from = 0.15, .to = 0.35, .start_values = 9})),
      20);
  EXPECT_GE(expect_stability_of_runs(
                scene, "stop.gap",
                sticking_branches(scene, "stop.gap", {.from = 0.05, .to = 0.4, .start_values = 9})),
            10);
}

double sticks_a_period(const SystemFamily& family, double value) {
  return support::events_a_period(family, value, EventKind::kStick, 200);
}

TEST(StickingBranch, RunsStickAsOftenAsTheirBranchSays) {
  const Scene scene = support::reference_scene("sticking/rayl3");
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result =
      sticking_branches(scene, "forcing.frequency", {.from = 0.12, .to = 0.3, .start_values = 9});
  int parted = 0, interrupted = 0;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special) {
      if (special.kind != SpecialKind::kChatterCompletes) continue;
      const double inward = special.at.value == branch.points.back().value ? -1.0 : 1.0;
      const auto rate = [&](double side) {
        return sticks_a_period(family, special.at.value * (1.0 + side * inward * 1e-5));
      };
      const double sticking = static_cast<double>(branch.sticking.size());
      EXPECT_EQ(rate(1.0), sticking) << special.at.value;
      EXPECT_EQ(std::abs(rate(-1.0) - sticking), 1.0) << special.at.value;
      ++parted;
      interrupted += special.interrupted;
    }
  EXPECT_GE(parted, 4);
  EXPECT_GE(interrupted, 1);
  EXPECT_LT(interrupted, parted);
}

// The two chatter points that the shipped scene names, each against runs from rest: they stick once
// a period on the one side and never on the other.
TEST(StickingBranch, OfTheShippedBeamRunsBetweenItsChatterPoints) {
  const Scene scene = support::shipped_scene("09_soft_stop_two_modes");
  const SystemFamily family(scene, "forcing.frequency");
  const OrbitBranches result =
      sticking_branches(scene, "forcing.frequency", {.from = 36.0, .to = 43.0, .start_values = 8});
  ASSERT_EQ(result.branches.size(), 1u);
  const OrbitBranch& branch = result.branches[0];
  EXPECT_EQ(branch.sticking, std::vector<int>{0});
  for (const OrbitBranchEnd end : branch.ends) EXPECT_EQ(end, OrbitBranchEnd::kChatterCompletes);
  const double low = branch.points.front().value, high = branch.points.back().value;
  EXPECT_NEAR(low, 37.2185, 5e-5);
  EXPECT_NEAR(high, 41.7776, 5e-5);
  EXPECT_EQ(sticks_a_period(family, low * (1.0 + 1e-5)), 1.0);
  EXPECT_EQ(sticks_a_period(family, low * (1.0 - 1e-5)), 0.0);
  EXPECT_EQ(sticks_a_period(family, high * (1.0 - 1e-5)), 1.0);
  EXPECT_EQ(sticks_a_period(family, high * (1.0 + 1e-5)), 0.0);
  EXPECT_GE(expect_stability_of_runs(scene, "forcing.frequency", result), 3);
}

// A mass held on its stop at the gap a < 0 by its spring, w = 1, is pressed by -a - cos t -
// cos(2 t + 0.3): the lowest of it is where sin t + 2 sin(2 t + 0.3) = 0.
TEST(StickingBranch, EndsAtRestWhereTheSumOfTwoHarmonicsLetsGo) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0]\ndamping_ratios = [0.05]\nparticipation = [1.0]\n"
      "[[forcing]]\namplitude = 1.0\nfrequency = 0.6\n"
      "[[forcing]]\namplitude = 1.0\norder = 2\nphase = 0.3\n"
      "[[stop]]\nshape = [1.0]\ngap = -1.0\nrestitution = 0.5\n",
      "two_harmonics.toml");
  double phase = 4.3;
  for (int step = 0; step < 8; ++step)
    phase -= (std::sin(phase) + 2.0 * std::sin(2.0 * phase + 0.3)) /
             (std::cos(phase) + 4.0 * std::cos(2.0 * phase + 0.3));
  const OrbitBranches result =
      sticking_branches(scene, "stop.gap", {.from = -1.4, .to = -0.9, .start_values = 8});
  const auto found = special_points(result, SpecialKind::kLiftOff);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0]->at.value, std::cos(phase) + std::cos(2.0 * phase + 0.3), 1e-13);
  EXPECT_NEAR(found[0]->impact()->phase, phase, 1e-9);
  EXPECT_TRUE(found[0]->solution.bracket->converged);
}

// Two modes held on their stop at the gap a < 0: q'' + 2 delta q' + w^2 q = f e^{i theta} - d
// force, b.q = a. The force is -a/(b W^-1 d), W = diag w^2, and the real part of (b H f)/(b H d)
// e^{i theta} with H = 1/(w^2 - Omega^2 + 2 i delta Omega). It touches zero where the two
// are as large.
TEST(StickingBranch, EndsAtRestWhereTheForceOfTheHeldMotionTouchesZero) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [1.0, 3.6]\ndamping_ratios = [0.05, 0.05]\n"
      "participation = [1.0, 0.4]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.6\n"
      "[[stop]]\nshape = [1.0, 0.6]\ngap = -0.8\nrestitution = 0.5\n",
      "two_modes.toml");
  const Complex first = 1.0 / Complex(1.0 - 0.36, 2.0 * 0.05 * 0.6);
  const Complex second = 1.0 / Complex(3.6 * 3.6 - 0.36, 2.0 * 0.05 * 3.6 * 0.6);
  const double norm = 1.0 + 0.36;  // d = b/(b.b)
  const Complex swing = (first + 0.6 * 0.4 * second) / ((first + 0.36 * second) / norm);
  const double compliance = (1.0 + 0.36 / (3.6 * 3.6)) / norm;
  const OrbitBranches result =
      sticking_branches(scene, "stop.gap", {.from = -1.4, .to = -0.7, .start_values = 8});
  ASSERT_EQ(result.branches.size(), 1u);
  const OrbitBranch& branch = result.branches[0];
  EXPECT_EQ(branch.ends[0], OrbitBranchEnd::kAtRest);
  EXPECT_EQ(branch.ends[1], OrbitBranchEnd::kParameterLimit);
  const auto found = special_points(result, SpecialKind::kLiftOff);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0]->at.value, -std::abs(swing) * compliance, 1e-12);
  EXPECT_NEAR(found[0]->impact()->phase, 0.5 * kTurn - std::arg(swing), 1e-9);
  // Runs leave the stop once a period on the one side and never on the other.
  const SystemFamily family(scene, "stop.gap");
  EXPECT_EQ(sticks_a_period(family, found[0]->at.value * (1.0 - 1e-6)), 1.0);
  EXPECT_EQ(sticks_a_period(family, found[0]->at.value * (1.0 + 1e-6)), 0.0);
}

// Beyond CH the orbits have a stuck phase more or less; seen from there it is the same point.
TEST(StickingBranch, IsFollowedAcrossItsChatterPoints) {
  const OrbitBranches result =
      sticking_branches(support::reference_scene("sticking/rayl3"), "forcing.frequency",
                        {.from = 0.13, .to = 0.17, .start_values = 1, .follow_depth = 2});
  int followed = 0;
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranch& from : result.branches)
      for (const SpecialPoint& origin : from.special) {
        if (origin.id != branch.origin) continue;
        EXPECT_EQ(branch.component, from.component);
        ++followed;
        // What doubles there is another orbit, with stuck phases of its own.
        if (origin.kind == SpecialKind::kPeriodDoubling) continue;
        // Across a grazing an impact is born or lost, and no stuck phase.
        EXPECT_EQ(std::abs(static_cast<int>(branch.sticking.size()) -
                           static_cast<int>(from.sticking.size())),
                  origin.kind == SpecialKind::kChatterCompletes ? 1 : 0);
        EXPECT_TRUE(std::any_of(branch.special.begin(), branch.special.end(),
                                [&](const SpecialPoint& special) {
                                  return special.kind == origin.kind &&
                                         std::abs(special.at.value / origin.at.value - 1.0) <=
                                             1e-10;
                                }))
            << origin.id;
      }
  EXPECT_GE(followed, 2);
  EXPECT_EQ(result.switched, followed);
}

// How many stuck phases are followed before a chatter is summed would be an accident.
TEST(StickingBranch, IsNotTracedWhereStuckPhasesHaveNoEnd) {
  const OrbitBranches result =
      sticking_branches(support::reference_scene("sticking/thrown_off", {"forcing.frequency=0.9"}),
                        "forcing.frequency", {.from = 0.88, .to = 0.92, .start_values = 2});
  EXPECT_TRUE(result.branches.empty());
  EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(), [](const std::string& note) {
    return note.find("stuck phases without end") != std::string::npos;
  }));
}

// A grazing is the same one from the side on which the approach touches and from the side on which
// the impact loses its speed.
TEST(StickingBranch, GrazingIsFoundFromEitherSide) {
  const OrbitBranches result = sticking_branches(support::reference_scene("sticking/rayl3"),
                                                 "forcing.frequency", {.from = 0.15, .to = 0.3});
  int pairs = 0;
  const auto grazings = special_points(result, SpecialKind::kGrazing);
  for (const SpecialPoint* a : grazings)
    for (const SpecialPoint* b : grazings) {
      if (!a->by_speed || b->by_speed || std::abs(a->at.value - b->at.value) > 1e-6) continue;
      EXPECT_LE(std::abs(a->at.value / b->at.value - 1.0), 1e-10);
      ++pairs;
    }
  EXPECT_GE(pairs, 1);
  for (const OrbitBranch& branch : result.branches)
    for (const OrbitBranchEnd end : branch.ends) EXPECT_NE(end, OrbitBranchEnd::kNotConverged);
}

// Two modes, two impacts outside the chatter that come and go: steps as long as 0.0046 rad/s led
// across the grazings where they do.
constexpr const char* kTwoModes =
    "[modal]\nfrequencies = [1.0, 3.3]\ndamping_ratios = [0.02, 0.02]\n"
    "participation = [1.0, 0.4]\n"
    "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.45\n"
    "[[stop]]\nshape = [1.0, 0.8]\ngap = 0.1\nrestitution = 0.4\n";

TEST(StickingBranch, EndsAtTheSameCornersHoweverLongItsSteps) {
  const Scene scene = parse_scene(kTwoModes, "two_modes.toml");
  const auto ends = [&](double max_step) {
    std::vector<std::pair<double, SpecialKind>> list;
    const OrbitBranches result =
        sticking_branches(scene, "forcing.frequency",
                          {.from = 0.43, .to = 0.49, .max_step = max_step, .start_values = 9});
    for (const OrbitBranch& branch : result.branches)
      for (const SpecialPoint& special : branch.special)
        list.emplace_back(special.at.value, special.kind);
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto coarse = ends(0.0046), fine = ends(0.0005);
  ASSERT_EQ(coarse.size(), fine.size());
  int grazings = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_EQ(coarse[i].second, fine[i].second);
    EXPECT_NEAR(coarse[i].first, fine[i].first, 1e-10);
    grazings += coarse[i].second == SpecialKind::kGrazing;
  }
  EXPECT_GE(grazings, 4);
}

}  // namespace
}  // namespace graze
