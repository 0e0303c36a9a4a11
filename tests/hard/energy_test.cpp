// E1 to E5 and M4: energy, reversal, order of the stops, contact at the start, many modes.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/detail/energy_changes.hpp"
#include "graze/motion/detail/motion.hpp"
#include "support/reached.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::expect_reached;
using support::for_seconds;
using support::off;
using support::oscillator;
using support::record_run;
using support::RecordedRun;
using support::relative;
using support::state_of;

TEST(HardCases, E1MomentumLawCountsItsEnergy) {
  support::Dice dice(1);
  for (int i = 0; i < 100'000; ++i) {
    const int n = 1 + dice.pick(6);
    const Vector row = dice.vector(n, -2.0, 2.0), before = dice.vector(n, -1.0, 1.0);
    const double r = dice.uniform(0.0, 1.0), v = row.dot(before);
    const Vector direction = momentum_direction(row);
    const Vector after = before - (1.0 + r) * v * direction;
    const double expected = -0.5 * (1.0 - r * r) * v * v / row.squaredNorm();
    const double energy = 0.5 * before.squaredNorm(), size = std::max(1.0, energy);
    expect_reached("E1", "momentum law: -(1 - r^2) v^2 m_eff/2, over max(1, energy)",
                   off(0.5 * after.squaredNorm() - energy, expected) / size, 1e-14);
    expect_reached("E1", "the same as counted",
                   off(impact_energy_change(row, direction, before, r), expected) / size, 1e-14);
  }
}

TEST(HardCases, E1GainOfTheCollocationLawIsCounted) {
  const std::pair<int, double> gains[] = {{2, 1.664358}, {5, 1.725385}};
  for (const auto& [modes, gain] : gains) {
    const Scene scene =
        support::shipped_scene("01_wagg_2004", {"beam.modes=" + std::to_string(modes)});
    const System system = assemble(scene);
    const Stop& stop = system.stops[0];
    const double r = stop.restitution().at_rest();
    expect_reached("E1", "collocation law: worst gain at the tip, r = .8",
                   off(worst_energy_gain(stop.row, stop.direction(), r), gain), 1e-6);
    // In a run: on the stop with the velocities that gain most, the balance shows it.
    const Matrix jump =
        Matrix::Identity(modes, modes) - (1.0 + r) * stop.direction() * stop.row.transpose();
    Vector worst = Eigen::JacobiSVD<Matrix>(jump, Eigen::ComputeFullV).matrixV().col(0);
    if (stop.row.dot(worst) < 0.0) worst = -worst;
    const State start{stop.row * (stop.gap / stop.row.squaredNorm()), worst};
    SimulationOptions options = for_seconds(1e-6);
    options.energy = true;
    const RecordedRun run = record_run(system, start, options);
    ASSERT_EQ(run.events.size(), 1u);
    expect_reached("E1", "the same gain in a run's totals, relative",
                   relative(run.result.totals.energy_added, 0.5 * (gain - 1.0)), 2e-6);
    expect_reached("E1", "its energy balance, defect over the largest entry",
                   std::abs(run.result.energy->defect()) / run.result.energy->size(), 1e-12);
  }
}

// r = 1, undamped and unforced: the energy stays what it was. Unit cantilever, stop at the tip.
System elastic_beam(int modes) {
  const double b[] = {1.8751040687119611664, 4.6940911329741745764, 7.8547574382376125649,
                      10.995540734875466991, 14.137168391046470581};
  System system{Vector(modes), NaturalModes{Vector::Zero(modes)}, {}};
  Vector row(modes);
  for (int j = 0; j < modes; ++j) {
    system.omega[j] = b[j] * b[j];
    row[j] = j % 2 == 0 ? 2.0 : -2.0;
  }
  system.stops.push_back({row, 0.05, ImpactLaw{momentum_direction(row), 1.0}});
  return system;
}

void expect_energy_kept(int modes, long long impacts, double allowed, const std::string& row) {
  const System system = elastic_beam(modes);
  State start = support::rest(system);
  start.qdot = Vector::LinSpaced(modes, 1.0, 0.4);
  SimulationOptions options = for_seconds(1e9);
  options.max_impacts = impacts;
  const Simulation run = simulate(system, start, options);
  EXPECT_EQ(run.totals.impacts, impacts);
  const double before = mechanical_energy(system, start.q, start.qdot);
  expect_reached("E2", row,
                 relative(mechanical_energy(system, run.final.q, run.final.qdot), before), allowed);
}

TEST(HardCases, E2ElasticImpactsKeepTheEnergy) {
  if (support::kSlowBuild) GTEST_SKIP() << "a million impacts";
  expect_energy_kept(2, 1'000'000, 1e-11, "N = 2, 1e6 impacts, |dE/E|");
  expect_energy_kept(5, 100'000, 1e-12, "N = 5, 1e5 impacts, |dE/E|");
}

TEST(HardCases, E3Reversal) {
  const System system = elastic_beam(2);
  const State start = state_of({0.0, 0.0}, {1.0, 0.3});
  Motion<double> out(system, {}, start.q, start.qdot);
  double flown = 0.0;
  for (int impacts = 0; impacts < 10;) {
    const Arrival<double> arrival = out.fly(1e6);
    ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
    out.impact();
    ++impacts;
    flown = out.instant().local;
  }
  // On a little into free flight, then back the same way.
  const double beyond = 0.01;
  ASSERT_EQ(out.fly(flown + beyond).kind, ArrivalKind::kTime);
  Motion<double> back(system, {}, out.q(), -out.qdot());
  int impacts = 0;
  const double end = out.instant().local;
  while (back.instant().local < end) {
    const Arrival<double> arrival = back.fly(end);
    if (arrival.kind != ArrivalKind::kContact) continue;
    back.impact();
    ++impacts;
  }
  EXPECT_EQ(impacts, 10);
  const double miss = std::max((back.q() - start.q).cwiseAbs().maxCoeff(),
                               (back.qdot() + start.qdot).cwiseAbs().maxCoeff());
  expect_reached("E3", "10 impacts and back", miss, 1e-12);
}

// Rows with b_i.b_i = 2, b_1.b_2 = 1.
System two_stops(double first, double second) {
  System system{Vector::Ones(2), NaturalModes{Vector::Zero(2)}, {}};
  const Vector a = Eigen::Vector2d(std::sqrt(2.0), 0.0);
  const Vector b = Eigen::Vector2d(std::sqrt(0.5), std::sqrt(1.5));
  system.stops.push_back({a, 0.0, ImpactLaw{momentum_direction(a), first}});
  system.stops.push_back({b, 0.0, ImpactLaw{momentum_direction(b), second}});
  return system;
}

// Velocities with the approach speeds v.
Vector approaching(const System& system, double v0, double v1) {
  Matrix rows(2, 2);
  rows << system.stops[0].row.transpose(), system.stops[1].row.transpose();
  return rows.inverse() * Eigen::Vector2d(v0, v1);
}

TEST(HardCases, E4TwoStopsAtOnce) {
  const System system = two_stops(1.0, 1.0);
  Motion<double> motion(system, {}, Vector::Zero(2), approaching(system, 1.0, 0.1));
  ASSERT_EQ(motion.fly(1.0).kind, ArrivalKind::kContact);
  const std::vector<ImpactShare<double>> shares = motion.impact();
  ASSERT_EQ(shares.size(), 2u);
  for (const ImpactShare<double>& share : shares) EXPECT_EQ(share.hit, share.stop == 0);
  expect_reached("E4", "the second stop takes no part: v+ = (-1, -.9)",
                 std::max(off(motion.approach_speed(0), -1.0), off(motion.approach_speed(1), -0.9)),
                 4.0 * 2.2e-16);
  EXPECT_EQ(motion.fly(0.1).kind, ArrivalKind::kTime);
}

// b_1 = (1, 0), b_2 = (-.8, .6): an impact on either throws the structure onto the other. With r =
// 1 they follow each other at one instant until it leaves both: v = (-1, 2), (2.2, -2),
// (-2.2, 1.52),
// (.232, -1.52), (-.232, -1.1488).
TEST(HardCases, E4AStopThatIsLeftTakesNoPart) {
  System system{Vector::Zero(2), NaturalModes{Vector::Zero(2)}, {}};
  const Vector a = Vector::Unit(2, 0), b = Eigen::Vector2d(-0.8, 0.6);
  system.stops.push_back({a, 0.0, ImpactLaw{a, 1.0}});
  system.stops.push_back({b, 0.0, ImpactLaw{b, 1.0}});
  const RecordedRun run =
      record_run(system, {Vector::Zero(2), approaching(system, -1.0, 2.0)}, for_seconds(1.0));
  const double speeds[] = {2.0, 2.2, 1.52, 0.232};
  ASSERT_EQ(run.events.size(), 4u);
  double miss = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Event& event = run.events[static_cast<std::size_t>(k)];
    EXPECT_EQ(event.time, 0.0);
    EXPECT_EQ(event.stop, k % 2 == 0 ? 1 : 0);
    miss = std::max(miss, off(event.speed, speeds[k]));
  }
  expect_reached("E4", "one impact after the other at one instant", miss, 16.0 * 2.2e-16);
  EXPECT_LE(run.result.totals.energy_added, 0.0);
}

TEST(HardCases, E4ImpulsesAreComplementary) {
  support::Dice dice(4);
  int resting = 0;
  for (int i = 0; i < 20'000; ++i) {
    const int modes = 2 + dice.pick(4), stops = 2 + dice.pick(modes - 1);
    System system{Vector::Ones(modes), NaturalModes{Vector::Zero(modes)}, {}};
    for (int k = 0; k < stops; ++k) {
      const Vector row = dice.vector(modes, -1.0, 1.0);
      system.stops.push_back(
          {row, 0.0, ImpactLaw{momentum_direction(row), dice.uniform(0.0, 1.0)}});
    }
    const Vector before = dice.vector(modes, -1.0, 1.0);
    Motion<double> motion(system, {}, Vector::Zero(modes), before);
    if (motion.fly(1.0).kind != ArrivalKind::kContact) continue;
    Vector undone = before;
    const std::vector<ImpactShare<double>> shares = motion.impact();
    resting += std::any_of(shares.begin(), shares.end(), [](const ImpactShare<double>& share) {
      return share.speed > 0.0 && share.speed_after == 0.0;
    });
    for (const ImpactShare<double>& share : shares) {
      const Stop& stop = system.stops[static_cast<std::size_t>(share.stop)];
      const double v = stop.row.dot(before), after = motion.approach_speed(share.stop);
      // Nothing rebounds where impacts would follow each other without end.
      const bool rests = share.speed_after == 0.0;
      const double w = after + (rests ? 0.0 : stop.restitution().at_rest() * std::max(v, 0.0));
      // Small determinants of nearly dependent rows multiply the rounding of the impulses.
      expect_reached("E4", "v+ + r v- <= 0", w, 1e-13);
      expect_reached("E4", "p >= 0", -share.impulse, 0.0);
      expect_reached("E4", "p (v+ + r v-) = 0, over 1 + p^2",
                     std::abs(share.impulse * w) / (1.0 + share.impulse * share.impulse), 1e-13);
      undone -= share.impulse * stop.direction();
    }
    expect_reached("E4", "q'+ = q'- - D p, over 1 + |q'+|",
                   (undone - motion.qdot()).norm() / (1.0 + undone.norm()), 1e-12);
    const double energy = before.squaredNorm();
    expect_reached("E4", "energy added, over the energy",
                   (motion.qdot().squaredNorm() - energy) / energy, 1e-13);
  }
  EXPECT_LE(resting, 2'000);  // few directions are as narrow as that
}

// Everything but the numbers of the stops is the same, bit for bit.
void expect_same_when_relabelled(const System& system, const State& start, double duration) {
  const RecordedRun run = record_run(system, start, for_seconds(duration));
  System relabelled = system;
  std::reverse(relabelled.stops.begin(), relabelled.stops.end());
  const int last = static_cast<int>(system.stops.size()) - 1;
  RecordedRun other = record_run(relabelled, start, for_seconds(duration));
  ASSERT_EQ(run.events.size(), other.events.size());
  EXPECT_EQ(run.result.final.q, other.result.final.q);
  EXPECT_EQ(run.result.final.qdot, other.result.final.qdot);
  for (Event& event : other.events) event.stop = last - event.stop;
  const auto by_time_and_stop = [](const Event& a, const Event& b) {
    return a.time != b.time ? a.time < b.time : a.stop < b.stop;
  };
  std::stable_sort(other.events.begin(), other.events.end(), by_time_and_stop);
  std::vector<Event> events = run.events;
  std::stable_sort(events.begin(), events.end(), by_time_and_stop);
  double differences = 0.0;
  for (std::size_t i = 0; i < events.size(); ++i)
    differences +=
        events[i].time != other.events[i].time || events[i].stop != other.events[i].stop ||
        events[i].kind != other.events[i].kind || events[i].speed != other.events[i].speed ||
        events[i].energy_change != other.events[i].energy_change;
  expect_reached("E4", "events that differ when the stops are relabelled", differences, 0.0);
}

TEST(HardCases, E4RelabellingChangesNothing) {
  for (const double r : {0.0, 0.4, 0.8, 1.0}) {
    System system = two_stops(r, 0.5);
    system.modal().forcing = HarmonicForcing{0.3, 0.4, Eigen::Vector2d(1.0, 0.7)};
    expect_same_when_relabelled(system, {Vector::Zero(2), approaching(system, 1.0, 0.1)}, 60.0);
    expect_same_when_relabelled(system, {Vector::Zero(2), approaching(system, 0.3, 0.4)}, 60.0);
  }
  const Scene scene = support::shipped_scene("07_two_stops");
  const System beam = assemble(scene);
  expect_same_when_relabelled(beam, initial_state(scene, beam), 5.0);
}

// Two oscillators that know nothing of each other do at the same instants what one does alone,
// chatter and sticking included.
void expect_copies_equal_one(double restitution, double gap, double frequency) {
  const System one = support::forced_oscillator(1.0, 0.05, gap, restitution, frequency, 0.5);
  System two{Vector::Ones(2), NaturalModes{Vector::Constant(2, 0.05)}, {}};
  two.modal().forcing = HarmonicForcing{frequency, 0.0, Vector::Constant(2, 0.5)};
  for (int j = 0; j < 2; ++j) {
    const Vector row = Vector::Unit(2, j);
    two.stops.push_back({row, gap, ImpactLaw{row, restitution}});
  }
  const RecordedRun alone = record_run(one, support::rest(one), for_seconds(80.0));
  const RecordedRun copies = record_run(two, support::rest(two), for_seconds(80.0));
  EXPECT_GE(alone.result.totals.impacts, 5);
  for (const EventKind kind : {EventKind::kStick, EventKind::kRelease}) {
    const auto count = [kind](const std::vector<Event>& events) {
      return std::count_if(events.begin(), events.end(),
                           [kind](const Event& event) { return event.kind == kind; });
    };
    EXPECT_EQ(count(copies.events), 2 * count(alone.events));
  }
  expect_reached("E4", "two uncoupled copies against one alone",
                 std::max(off(copies.result.final.q[0], alone.result.final.q[0]),
                          off(copies.result.final.q[1], alone.result.final.q[0])),
                 4.0 * 2.2e-16);
}

TEST(HardCases, E4UncoupledCopiesEqualOneAlone) {
  // (A chatter on both stops at once is followed to the rounding of its speeds, so that the numbers
  // of impacts differ.)
  expect_copies_equal_one(0.7, 0.3, 0.9);
  expect_copies_equal_one(0.3, 0.1, 0.3);
  expect_copies_equal_one(0.0, 0.1, 0.3);
}

TEST(HardCases, E5ContactAtTheStart) {
  const System system = oscillator(1.0, 0.0, 0.5, 0.8);
  const RecordedRun approaching = record_run(system, state_of({0.5}, {0.3}), for_seconds(1e-3));
  ASSERT_EQ(approaching.events.size(), 1u);
  EXPECT_EQ(approaching.events[0].time, 0.0);
  EXPECT_EQ(approaching.events[0].speed, 0.3);
  EXPECT_EQ(approaching.result.outcome, RunOutcome::kReachedEnd);

  const RecordedRun leaving = record_run(system, state_of({0.5}, {-0.3}), for_seconds(1e-3));
  EXPECT_TRUE(leaving.events.empty());

  // At rest on the stop the spring pulls it away.
  const RecordedRun pulled = record_run(system, state_of({0.5}, {0.0}), for_seconds(3.0));
  EXPECT_TRUE(pulled.events.empty());
  EXPECT_EQ(pulled.result.outcome, RunOutcome::kReachedEnd);
  expect_reached("E5", "at rest and pulled: leaves freely",
                 off(pulled.result.final.q[0], 0.5 * std::cos(3.0)), 1e-14);

  // A force of 1 against a spring force of .5: pushed, at rest.
  const System pushed = support::forced_oscillator(1.0, 0.0, 0.5, 0.8, 0.1, 1.0);
  const RecordedRun stuck = record_run(pushed, state_of({0.5}, {0.0}), for_seconds(1e-3));
  EXPECT_TRUE(stuck.events.empty());
  EXPECT_EQ(stuck.result.stuck, std::vector<int>{0});
  expect_reached("E5", "at rest and pushed: contact force",
                 off(stuck.result.forces[0], std::cos(0.1e-3) - 0.5), 1e-15);
  // Neither pushed nor pulled: it stays where it is.
  const RecordedRun balanced =
      record_run(oscillator(1.0, 0.1, 0.0, 0.8), state_of({0.0}, {0.0}), for_seconds(10.0));
  EXPECT_TRUE(balanced.events.empty());
  EXPECT_EQ(balanced.result.final.q[0], 0.0);
}

TEST(HardCases, E5StartBeyondTheStopIsAnError) {
  const std::string text =
      "[modal]\nfrequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = 0.5\nrestitution = 0.8\n"
      "[initial]\nq = [0.75]\nqdot = [0.0]\n";
  const Scene scene = parse_scene(text, "beyond.toml");
  const System system = assemble(scene);
  try {
    initial_state(scene, system);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("beyond.toml:8:"), std::string::npos) << message;
    EXPECT_NE(message.find("initial.q"), std::string::npos) << message;
    EXPECT_NE(message.find("0.25"), std::string::npos) << message;
  }
}

TEST(HardCases, M4ManyModesEndAtTheirBudget) {
  const Scene scene = support::shipped_scene("02_wagg_momentum", {"beam.modes=32"});
  const System system = assemble(scene);
  SimulationOptions options = support::for_impacts(500, 10.0);
  const RecordedRun run = record_run(system, initial_state(scene, system), options);
  EXPECT_EQ(run.result.outcome, RunOutcome::kEventBudget);
  EXPECT_FALSE(run.result.message.empty());
  EXPECT_EQ(run.result.totals.impacts, 500);
  EXPECT_GT(run.result.end_time, 0.1);
  EXPECT_EQ(run.result.final.q.size(), 32);
  expect_reached("M4", "penetration before the budget ends the run, m",
                 -*run.result.totals.smallest_gap, 1e-12);
}

}  // namespace
}  // namespace graze
