#include "graze/report/picture/pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Event event_of(EventKind kind, double time, int stop = 0) {
  Event event;
  event.kind = kind;
  event.time = time;
  event.stop = stop;
  event.speed = 1.0;
  event.force = 3.0;
  return event;
}

// A sample every second from `first` to `last`, in which the stops hold with these forces.
SimulationRecord record_of(int first, int last, const std::vector<double>& forces,
                           const std::vector<Event>& events) {
  SimulationRecord record;
  record.system = support::oscillator(1.0, 0.1, 0.0, 0.5);
  while (record.system.stops.size() < forces.size())
    record.system.stops.push_back(record.system.stops[0]);
  for (int t = first; t <= last; ++t)
    record.samples.push_back({static_cast<double>(t), support::rest(record.system), 0.0, forces, {}});
  record.run.end_time = last;
  record.run.final = support::rest(record.system);
  record.run.forces = forces;
  record.events = events;
  return record;
}

void expect_phases(const std::vector<TimeSpan>& phases,
                   const std::vector<std::pair<double, double>>& expected) {
  ASSERT_EQ(phases.size(), expected.size());
  for (std::size_t i = 0; i < phases.size(); ++i) {
    EXPECT_EQ(phases[i].start, expected[i].first);
    EXPECT_EQ(phases[i].end, expected[i].second);
  }
}

TEST(StuckPhases, LastFromStickToReleaseOfTheirStop) {
  const SimulationRecord record =
      record_of(0, 10, {0.0, 0.0},
                {event_of(EventKind::kStick, 1.0), event_of(EventKind::kStick, 2.0, 1),
                 event_of(EventKind::kRelease, 3.0), event_of(EventKind::kRelease, 4.0, 1),
                 event_of(EventKind::kStick, 5.0), event_of(EventKind::kRelease, 6.0)});
  expect_phases(stuck_phases(record, 0, {0.0, 10.0}), {{1.0, 3.0}, {5.0, 6.0}});
  expect_phases(stuck_phases(record, 1, {0.0, 10.0}), {{2.0, 4.0}});
}

TEST(StuckPhases, MayBeginBeforeTheWindowAndOutlastIt) {
  // The stick at 1 s is before the window, which begins at 2 s.
  const SimulationRecord record =
      record_of(2, 10, {3.0},
                {event_of(EventKind::kStick, 1.0), event_of(EventKind::kRelease, 4.0),
                 event_of(EventKind::kStick, 7.0)});
  expect_phases(stuck_phases(record, 0, {2.0, 10.0}), {{2.0, 4.0}, {7.0, 10.0}});
  expect_phases(stuck_phases(record_of(2, 10, {3.0}, {}), 0, {2.0, 10.0}), {{2.0, 10.0}});
  expect_phases(stuck_phases(record_of(2, 10, {0.0}, {}), 0, {2.0, 10.0}), {});
}

TEST(StuckPhases, WithoutSamplesComeFromTheEventsAndTheEnd) {
  SimulationRecord record = record_of(1, 0, {0.0}, {});
  record.run.end_time = 5.0;
  expect_phases(stuck_phases(record, 0, {0.0, 5.0}), {});
  record.run.stuck = {0};
  expect_phases(stuck_phases(record, 0, {0.0, 5.0}), {{0.0, 5.0}});
  record.run.stuck = {};
  record.events = {event_of(EventKind::kRelease, 2.0)};
  expect_phases(stuck_phases(record, 0, {0.0, 5.0}), {{0.0, 2.0}});
}

TEST(StuckPhases, OfAChatterCutShortBeginWithIt) {
  const SimulationRecord record =
      record_of(0, 10, {0.0},
                {event_of(EventKind::kImpact, 1.0), event_of(EventKind::kImpact, 2.0),
                 event_of(EventKind::kChatter, 2.0), event_of(EventKind::kRelease, 3.0)});
  expect_phases(stuck_phases(record, 0, {0.0, 10.0}), {{2.0, 3.0}});
}

TEST(MotionSeen, GathersTheStopsOfAPlaceOnBothSides) {
  SimulationRecord record = record_of(0, 2, {0.0}, {});
  const Vector along = Vector::Constant(1, 2.0);
  record.system.stops.push_back({-Vector::Ones(1), 0.25, ImpactLaw{-Vector::Ones(1), 0.5}});
  record.system.stops.push_back({along, 0.5, ImpactLaw{0.5 * Vector::Ones(1), 0.5}});
  record.events = {event_of(EventKind::kImpact, 1.5, 1)};
  const MotionSeen seen = motion_seen(record);
  ASSERT_EQ(seen.places.size(), 2U);
  ASSERT_EQ(seen.places[0].stops.size(), 2U);
  EXPECT_EQ(seen.places[0].stops[1].place, -0.25);
  EXPECT_EQ(seen.places[0].stops[1].sense, -1.0);
  ASSERT_EQ(seen.places[0].impacts.size(), 1U);
  EXPECT_EQ(seen.places[0].impacts[0].before, -1.0);
  EXPECT_EQ(seen.places[0].impacts[0].after, 0.5);
  EXPECT_EQ(seen.places[1].stops[0].index, 2);
  EXPECT_TRUE(seen.places[1].impacts.empty());
}

// Renderers draw a fill from one end of the axis to the other where its ends are infinite.
TEST(MotionChart, ShadesWhatLiesBehindTheStopsOfBothSides) {
  SimulationRecord record = record_of(0, 2, {0.0}, {});
  record.system.stops.push_back({-Vector::Ones(1), 0.25, ImpactLaw{-Vector::Ones(1), 0.5}});
  int shaded = 0;
  for (const std::vector<ChartPanel>& row : motion_chart(record).rows)
    for (const ChartPanel& panel : row)
      for (const ChartFill& fill : panel.fills) {
        if (fill.title != "behind the stop") continue;
        ++shaded;
        EXPECT_LT(fill.from, fill.to);
        EXPECT_FALSE(fill.from < -0.1 && -0.1 < fill.to);  // between the stops at 0 and -0.25
        EXPECT_TRUE(std::isinf(fill.from) != std::isinf(fill.to));
      }
  EXPECT_GE(shaded, 2);
}

TEST(MotionSeen, BreaksTheForceWhereTheStopOpens) {
  SimulationRecord record = record_of(
      0, 3, {0.0}, {event_of(EventKind::kStick, 0.5), event_of(EventKind::kRelease, 1.5)});
  record.samples[1].forces = {2.0};
  const MotionSeen seen = motion_seen(record);
  ASSERT_EQ(seen.forces.size(), 1U);
  const std::vector<std::pair<double, double>> expected = {
      {0.5, 3.0}, {1.0, 2.0}, {1.5, 0.0}, {1.5, kNaN}};
  ASSERT_EQ(seen.forces[0].force.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(seen.forces[0].force[i].time, expected[i].first);
    if (i + 1 < expected.size())
      EXPECT_EQ(seen.forces[0].force[i].value, expected[i].second);
    else
      EXPECT_TRUE(std::isnan(seen.forces[0].force[i].value));
  }
}

// The run, and of its samples the last ones.
SimulationRecord simulated(const System& system, double duration, std::size_t last) {
  SimulationRecord record;
  record.system = system;
  SimulationOptions options;
  options.duration = duration;
  options.energy = true;
  RunListeners listeners;
  listeners.sample_rate = 50.0;
  listeners.event = [&](const Event& event) { record.events.push_back(event); };
  listeners.sample = [&](const Sample& sample) { record.samples.push_back(sample); };
  record.run = simulate(system, support::rest(system), options, listeners);
  if (record.samples.size() > last)
    record.samples.erase(record.samples.begin(),
                         record.samples.end() - static_cast<std::ptrdiff_t>(last));
  return record;
}

System pressed_oscillator() { return support::forced_oscillator(1.0, 0.05, 0.0, 0.5, 0.5, 0.3); }

// A structure rests on a rigid stop for as long as its run says, and never on a spring.
TEST(StuckPhases, LastAsLongAsTheRunSays) {
  System rigid = pressed_oscillator(), sprung = pressed_oscillator();
  for (System* system : {&rigid, &sprung}) system->modal().load = Vector::Constant(1, 1.5);
  // k x with k = 9: it presses on the spring at the start, at rest and unloaded.
  sprung.stops[0] = {Vector::Ones(1), 0.0, ContactForce{9.0}};
  for (const System& system : {rigid, sprung}) {
    const SimulationRecord record = simulated(system, 60.0, 100'000);
    double total = 0.0;
    for (const TimeSpan& phase : stuck_phases(record, 0, {0.0, 60.0}))
      total += phase.end - phase.start;
    EXPECT_NEAR(total, record.run.totals.stuck_time, 1e-12 * 60.0);
    // A later window begins within a contact, or a rest, like this one.
    const SimulationRecord end = simulated(system, 60.0, 1'000);
    for (const TimeSpan& phase : stuck_phases(end, 0, {end.samples.front().time, 60.0}))
      EXPECT_FALSE(system.has_compliant_stop()) << phase.start;
  }
}

TEST(MotionSeen, EnergyRisesByTheSumOfTheWorksSinceTheWindowBegan) {
  for (const std::size_t last : {100'000U, 1'000U}) {
    const MotionSeen seen = motion_seen(simulated(pressed_oscillator(), 60.0, last));
    ASSERT_EQ(seen.energy.size(), 4U);
    EXPECT_EQ(seen.energy[0].name, "energy");
    EXPECT_EQ(seen.energy[1].name, "forcing");
    EXPECT_EQ(seen.energy[2].name, "damping");
    EXPECT_EQ(seen.energy[3].name, "impacts");
    const DrawnCurve& energy = seen.energy[0].curve;
    for (std::size_t i = 0; i < energy.size(); ++i) {
      double sum = energy[0].value;
      for (std::size_t k = 1; k < seen.energy.size(); ++k) sum += seen.energy[k].curve[i].value;
      // The works reach 1 J or so, each a sum of a few thousand arcs' at most.
      EXPECT_NEAR(sum, energy[i].value, 1e-12);
    }
  }
}

TEST(MotionSeen, ReachesTheEndOfTheRunBetweenTwoSamples) {
  const SimulationRecord record = simulated(pressed_oscillator(), 10.013, 100'000);
  const MotionSeen seen = motion_seen(record);
  EXPECT_EQ(seen.window.end, record.run.end_time);
  EXPECT_EQ(seen.places[0].motion.back().time, record.run.end_time);
}

// A branch of orbits with two impacts a period; from the fourth point on the second of them has the
// smaller phase and comes first.
BranchRecord relabelled_branch() {
  BranchRecord record;
  record.from = 0.0;
  record.to = 1.0;
  record.traced.parameter = "stop.restitution";
  OrbitBranch branch;
  branch.pattern = {1, {0, 0}};
  for (int i = 0; i <= 6; ++i) {
    OrbitBranchPoint point;
    point.value = i / 6.0;
    point.orbit.admissible = true;
    point.orbit.stable = true;
    OrbitImpact slow, fast;
    slow.speed = 1.0 + 0.01 * i;
    fast.speed = 2.0 - 0.01 * i;
    point.orbit.impacts = {slow, fast};
    if (i >= 3) std::swap(point.orbit.impacts[0], point.orbit.impacts[1]);
    branch.points.push_back(point);
  }
  SpecialPoint fold;
  fold.id = "LP1";
  fold.at = branch.points.back();
  branch.special.push_back(fold);
  record.traced.branches.push_back(branch);
  return record;
}

// Null where there is none.
const ChartSeries* series_of(const ChartPanel& panel, const std::string& look) {
  for (const ChartSeries& series : panel.series)
    if (series.look.id == look) return &series;
  return nullptr;
}

TEST(ChartOfBranches, ShowsEveryImpactOfAnOrbitAsACurveOfItsOwn) {
  const Chart chart = chart_of(relabelled_branch());
  ASSERT_EQ(chart.rows.size(), 1U);
  const ChartPanel& panel = chart.rows[0][0];
  const ChartSeries* stable = series_of(panel, "stable");
  ASSERT_NE(stable, nullptr);
  std::vector<std::size_t> lengths = {0};
  for (std::size_t i = 0; i < stable->y.size(); ++i) {
    if (std::isnan(stable->y[i])) {
      lengths.push_back(0);
      continue;
    }
    if (lengths.back()++ > 0) {
      EXPECT_NEAR(stable->y[i], stable->y[i - 1], 0.011);
    }
  }
  EXPECT_EQ(lengths, (std::vector<std::size_t>{7, 7}));
  // The fold is marked on both, and named once.
  const ChartSeries* folds = series_of(panel, "LP");
  ASSERT_NE(folds, nullptr);
  EXPECT_EQ(folds->x.size(), 2U);
  ASSERT_EQ(panel.names.size(), 2U);
  EXPECT_EQ(panel.names[0].text, "LP1");
  EXPECT_EQ(panel.names[1].text, "(1,2)");
}

TEST(ChartOfBranches, AMultiplierThatPassesTheCircleIsNoOpenStability) {
  BranchRecord record = relabelled_branch();
  std::vector<OrbitBranchPoint>& points = record.traced.branches[0].points;
  points[2].orbit.stable.reset();
  points[3].orbit.stable = false;
  EXPECT_EQ(series_of(chart_of(record).rows[0][0], "open"), nullptr);
  points[3].orbit.stable.reset();
  const Chart chart = chart_of(record);
  EXPECT_NE(series_of(chart.rows[0][0], "open"), nullptr);
}

// The axis ends below zero at twice the largest exponent, .5 here.
TEST(ChartOfDiagram, MarksExponentsThatTheAxisCuts) {
  DiagramRecord record;
  record.branches.traced.parameter = "stop.gap";
  record.swept.options.exponent_periods = 1;
  for (const double lower : {-0.5, -40.0, -std::numeric_limits<double>::infinity()}) {
    SweepRow row;
    row.value = static_cast<double>(record.swept.rows.size());
    row.exponents.emplace();
    row.exponents->values = (Vector(2) << 0.5 - row.value, lower).finished();
    record.swept.rows.push_back(row);
  }
  const Chart chart = chart_of(record);
  const ChartPanel& panel = chart.rows.back()[0];
  ASSERT_EQ(panel.y.name, "Lyapunov exponents");
  EXPECT_LT(panel.y.range.low, -1.0);
  EXPECT_GT(panel.y.range.low, -1.1);
  const auto heights = [&](const char* look) {
    const ChartSeries* series = series_of(panel, look);
    return series ? series->y : std::vector<double>();
  };
  EXPECT_EQ(heights("largest"), (std::vector<double>{0.5, -0.5}));
  EXPECT_EQ(heights("lower"), std::vector<double>{-0.5});
  // The largest of the last row, -1.5, is below the axis too.
  EXPECT_EQ(heights("cut"), (std::vector<double>{-1.0, -1.0, -1.0}));
}

std::vector<ProbeRow> probes_of(const std::vector<ProbeQuantity>& quantities) {
  std::vector<ProbeRow> probes;
  for (const ProbeQuantity quantity : quantities)
    probes.push_back({quantity, Vector::Constant(1, 1.0 + static_cast<double>(probes.size())),
                      quantity == ProbeQuantity::kVelocity, 0.0});
  return probes;
}

TEST(MotionSeen, HoldsTheProbesAtEverySample) {
  SimulationRecord record = simulated(pressed_oscillator(), 10.013, 100'000);
  record.probes = probes_of({ProbeQuantity::kDisplacement, ProbeQuantity::kVelocity});
  const MotionSeen seen = motion_seen(record);
  ASSERT_EQ(seen.probes.size(), 2U);
  ASSERT_EQ(seen.probes[1].curve.size(), record.samples.size() + 1);
  EXPECT_EQ(seen.probes[1].number, 2);
  EXPECT_EQ(seen.probes[1].curve[7].value, 2.0 * record.samples[7].state.qdot[0]);
  EXPECT_EQ(seen.probes[0].curve.back().time, record.run.end_time);
  EXPECT_EQ(seen.probes[0].curve.back().value, record.run.final.q[0]);
  record.samples.clear();
  EXPECT_TRUE(motion_seen(record).probes.empty());
}

// One panel a unit; curves that share one are told apart.
TEST(MotionChart, ShowsProbesInPanelsByTheirUnit) {
  SimulationRecord record = simulated(pressed_oscillator(), 20.0, 100'000);
  // Names of the panels' vertical axes that are of probes, with the titles of their curves.
  const auto shown = [&] {
    std::vector<std::string> list;
    for (const std::vector<ChartPanel>& row : motion_chart(record).rows)
      for (const ChartPanel& panel : row) {
        std::string titles;
        for (const ChartSeries& series : panel.series)
          if (series.look.id.starts_with("probe")) titles += " " + series.title;
        if (!titles.empty()) list.push_back(panel.y.name + " (" + panel.y.unit + "):" + titles);
      }
    return list;
  };
  EXPECT_TRUE(shown().empty());
  record.probes = probes_of({ProbeQuantity::kStrain});
  EXPECT_EQ(shown(), std::vector<std::string>{"strain\nprobe 1 (): probe 1"});
  record.probes =
      probes_of({ProbeQuantity::kStrain, ProbeQuantity::kDisplacement, ProbeQuantity::kStrain,
                 ProbeQuantity::kVelocity, ProbeQuantity::kDeflection});
  EXPECT_EQ(shown(),
            (std::vector<std::string>{"strain\nprobes (): probe 1 probe 3",
                                      "displacement u,\ndeflection along u (m): probe 2 probe 5",
                                      "velocity u’\nprobe 4 (m/s): probe 4"}));
  record.probes = probes_of(std::vector<ProbeQuantity>(8, ProbeQuantity::kVelocity));
  EXPECT_EQ(shown(), std::vector<std::string>{"velocity u’\nprobes (m/s): probe 1 probe 2 probe 3 "
                                              "probe 4 probe 5 probe 6"});
}

TEST(MotionChart, DrawsWhateverWasRecorded) {
  SimulationRecord two_places = simulated(pressed_oscillator(), 20.0, 100'000);
  two_places.system.stops.push_back(
      {Vector::Constant(1, 2.0), 30.0, ImpactLaw{Vector::Constant(1, 0.5), 0.5}});
  System free{Vector::Ones(1), NaturalModes{Vector::Zero(1)}, {}};
  SimulationRecord not_finite = simulated(pressed_oscillator(), 20.0, 100'000);
  not_finite.samples.back().state.q[0] = kNaN;
  not_finite.samples.back().energy->now = kNaN;
  not_finite.probes = probes_of({ProbeQuantity::kStrain, ProbeQuantity::kStrain});
  not_finite.run.final.q[0] = kNaN;
  not_finite.run.final.qdot[0] = std::numeric_limits<double>::infinity();
  const ScratchFolder scratch;
  const std::string picture = (scratch / "x.svg").string();
  for (const SimulationRecord& record :
       {simulated(pressed_oscillator(), 60.0, 100'000), simulated(pressed_oscillator(), 0.0, 1),
        record_of(0, 0, {1.0}, {}), record_of(1, 0, {0.0}, {event_of(EventKind::kImpact, 0.0)}),
        two_places, not_finite, simulated(free, 10.0, 100'000)}) {
    EXPECT_NO_THROW(draw_chart(picture, record.info, motion_chart(record)));
    EXPECT_GT(read_text(picture).size(), 1000U);
    EXPECT_EQ(read_text(scratch / "x.gp").find("nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace graze
