#include "graze/report/picture/pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/picture/detail/picture_curve.hpp"
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
    record.samples.push_back({static_cast<double>(t), support::rest(record.system), forces, {}});
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

TEST(LabelCurves, KeepsItsDistance) {
  GnuplotScript script;
  std::vector<CurveLabel> labels;
  for (const double at : {0.5, 0.52, 0.51, 1.0, 0.99, -3.0, kNaN}) labels.push_back({at, "x", "y"});
  AxisRange axis;
  axis.include(0.0);
  axis.include(1.0);
  label_curves(script, labels, axis, 0.1);
  std::istringstream lines(script.text());
  std::vector<double> places;
  for (std::string line; std::getline(lines, line);) {
    const std::string before = "graph 1.015, graph ";
    places.push_back(std::stod(line.substr(line.find(before) + before.size())));
  }
  ASSERT_EQ(places.size(), labels.size());
  EXPECT_EQ(places.front(), 0.0);
  EXPECT_EQ(places.back(), 1.0);
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_GT(places[i] - places[i - 1], 0.0999);
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

// Rows of numbers of a data set beside a script, those of each line apart.
std::vector<std::vector<std::pair<double, double>>> lines_in(const std::string& data,
                                                             const std::string& name) {
  std::vector<std::vector<std::pair<double, double>>> lines(1);
  const std::size_t start = data.find("# [" + name + "]\n");
  if (start == std::string::npos) return {};
  std::istringstream rows(data.substr(data.find('\n', start) + 1));
  for (std::string row; std::getline(rows, row) && !row.starts_with("#");) {
    std::istringstream numbers(row);
    double x = 0.0, y = 0.0;
    if (numbers >> x >> y)
      lines.back().emplace_back(x, y);
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

TEST(DrawBranches, ShowsEveryImpactOfAnOrbitAsACurveOfItsOwn) {
  const ScratchFolder scratch;
  draw_branches((scratch / "x.svg").string(), relabelled_branch());
  const std::string data = read_text(scratch / "x.gp.dat");
  std::size_t curves = 0;
  for (const auto& line : lines_in(data, "stable")) {
    if (line.empty()) continue;
    ++curves;
    EXPECT_EQ(line.size(), 7U);
    for (std::size_t i = 1; i < line.size(); ++i)
      EXPECT_NEAR(line[i].second, line[i - 1].second, 0.011);
  }
  EXPECT_EQ(curves, 2U);
  // The fold is marked on both.
  const auto marks = lines_in(data, "LP");
  ASSERT_EQ(marks.size(), 1U);
  EXPECT_EQ(marks[0].size(), 2U);
}

TEST(DrawBranches, AMultiplierThatPassesTheCircleIsNoOpenStability) {
  BranchRecord record = relabelled_branch();
  std::vector<OrbitBranchPoint>& points = record.traced.branches[0].points;
  points[2].orbit.stable.reset();
  points[3].orbit.stable = false;
  const ScratchFolder scratch;
  const auto drawn = [&] {
    draw_branches((scratch / "x.svg").string(), record);
    return read_text(scratch / "x.gp");
  };
  EXPECT_EQ(drawn().find("stability open"), std::string::npos);
  points[3].orbit.stable.reset();
  EXPECT_NE(drawn().find("stability open"), std::string::npos);
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
TEST(DrawSimulation, ShowsProbesInPanelsByTheirUnit) {
  SimulationRecord record = simulated(pressed_oscillator(), 20.0, 100'000);
  const ScratchFolder scratch;
  const auto script = [&] {
    draw_simulation((scratch / "x.svg").string(), record);
    return read_text(scratch / "x.gp");
  };
  const auto count = [](const std::string& text, const std::string& part) {
    int times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++times;
    return times;
  };
  const int panels = count(script(), "set yrange");
  record.probes = probes_of({ProbeQuantity::kStrain});
  std::string text = script();
  EXPECT_EQ(count(text, "set yrange"), panels + 1);
  EXPECT_NE(text.find("'probe 1'"), std::string::npos);
  record.probes =
      probes_of({ProbeQuantity::kStrain, ProbeQuantity::kDisplacement, ProbeQuantity::kStrain,
                 ProbeQuantity::kVelocity, ProbeQuantity::kDeflection});
  text = script();
  EXPECT_EQ(count(text, "set yrange"), panels + 3);
  for (const char* name : {"'probes'", "'displacement u,'", "'deflection along u (m)'",
                           "'probe 4 (m/s)'", "'probe 1'", "'probe 5'"})
    EXPECT_NE(text.find(name), std::string::npos) << name;
  EXPECT_EQ(text.find("'probe 4'"), std::string::npos);
  record.probes = probes_of(std::vector<ProbeQuantity>(8, ProbeQuantity::kVelocity));
  EXPECT_NE(script().find("the first 6 of 8 probes"), std::string::npos);
}

TEST(DrawSimulation, DrawsWhateverWasRecorded) {
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
    EXPECT_NO_THROW(draw_simulation(picture, record));
    EXPECT_GT(read_text(picture).size(), 1000U);
    EXPECT_EQ(read_text(scratch / "x.gp").find("nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace graze
