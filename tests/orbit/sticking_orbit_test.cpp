// Orbits that stick: events against 60-digit runs, multipliers against central differences of the
// simulated map and against the same map in 50 digits, the price of closing a chatter.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "graze/base/angle.hpp"
#include "graze/flow/extended.hpp"
#include "graze/orbit/repetition.hpp"
#include "graze/orbit/sticking_orbit.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::number;
using support::TableRow;

struct Found {
  System system;
  Orbit orbit;
};

// The orbit that the motion of a scene settles on.
Found settled_orbit(const Scene& scene, std::optional<double> closure_speed = {}) {
  Found found{assemble(scene), {}};
  const State start = initial_state(scene, found.system);
  const double speed =
      closure_speed.value_or(default_closure_speed(found.system, start, kDefaultClosureTolerance));
  RepetitionOptions options;
  options.closure_speed = speed;
  const Repetition repetition = find_repetition(found.system, start, options);
  EXPECT_TRUE(repetition.sticks) << repetition.why_not;
  const StickingOrbitAnswer answer =
      sticking_orbit(found.system, repetition.at_start, repetition.period, {speed, 10'000'000, {}});
  EXPECT_TRUE(answer.orbit) << answer.why_not;
  if (answer.orbit) found.orbit = *answer.orbit;
  return found;
}

Scene sticking_case(const std::string& name, const std::vector<std::string>& settings = {}) {
  return support::reference_scene("sticking/" + name, settings);
}

// The beam of the reference cases, softened until its motion repeats.
Scene beam(const char* law, int modes, double frequency) {
  return sticking_case("beam2", {"beam.modes=" + std::to_string(modes),
                                 "forcing.frequency=" + std::to_string(frequency),
                                 "stop.impulse=\"" + std::string(law) + "\"",
                                 "stop.restitution=0.2", "damping.viscous=0.05"});
}

int exact_zeros(const Orbit& orbit) {
  return static_cast<int>(
      std::count_if(orbit.multipliers.begin(), orbit.multipliers.end(),
                    [](const Eigenvalue& m) { return m.value == Complex(0.0) && m.error == 0.0; }));
}

double turned(double a, double b) { return std::abs(std::remainder(a - b, kTurn)); }

// ---------------------------------------------------------------- events

// tests/reference/sticking_motion.csv: 60 digits, every chatter followed to its end. Its last full
// period comes after the motion has stuck, and so lies on the orbit to the modulus of the largest
// multiplier.
void expect_listed_events(const std::string& name, const std::vector<TableRow>& rows,
                          double tolerance) {
  SCOPED_TRACE(name);
  const Found found = settled_orbit(sticking_case(name));
  const Orbit& orbit = found.orbit;
  ASSERT_TRUE(orbit.sticking);
  ASSERT_EQ(orbit.period, 1);
  const double period = found.system.period(), end = number(rows.back(), "time");
  std::size_t impacts = 0, sticks = 0, releases = 0;
  for (const TableRow& row : rows) {
    const double time = number(row, "time");
    if (!(time > end - period)) continue;
    const int stop = static_cast<int>(number(row, "stop")) - 1;
    const double phase = found.system.forcing->frequency * time + found.system.forcing->phase;
    double nearest = kTurn, speed_miss = 0.0;
    const auto consider = [&](int at_stop, double at_phase, double miss) {
      if (at_stop != stop || !(turned(at_phase, phase) < nearest)) return;
      nearest = turned(at_phase, phase);
      speed_miss = miss;
    };
    if (row.at("kind") == "impact") {
      ++impacts;
      for (const OrbitImpact& impact : orbit.impacts)
        consider(impact.stop, impact.phase, impact.speed - number(row, "speed"));
    }
    for (const OrbitHold& hold : orbit.sticking->holds) {
      if (row.at("kind") == "stick") consider(hold.stop, hold.from.phase, 0.0);
      if (row.at("kind") == "release") consider(hold.stop, hold.to.phase, 0.0);
    }
    sticks += row.at("kind") == "stick";
    releases += row.at("kind") == "release";
    EXPECT_LE(nearest, tolerance) << "row " << row.at("event");
    EXPECT_LE(std::abs(speed_miss), tolerance) << "row " << row.at("event");
  }
  EXPECT_EQ(sticks, orbit.sticking->holds.size());
  EXPECT_EQ(releases, orbit.sticking->holds.size());
  EXPECT_LE(impacts, orbit.impacts.size());
  EXPECT_GE(impacts, 3u);
}

TEST(StickingOrbit, EventsAreThoseOfSixtyDigits) {
  std::map<std::string, std::vector<TableRow>> cases;
  for (const TableRow& row : support::read_table("sticking_motion.csv"))
    cases[row.at("case")].push_back(row);
  // Closing the chatter moves its end by some 100 (v_c/V)^2 of a period: 1e-10.
  for (const char* name : {"Z2a", "Z2b", "Z2c", "Z2s", "two_sides", "two_stops2"})
    expect_listed_events(name, cases.at(name), 1e-9);
}

// ---------------------------------------------------------------- multipliers

// The simulated map over the orbit's periods from its section, by a run.
State simulated(const Found& found, const State& start) {
  const OrbitSticking& sticking = *found.orbit.sticking;
  RunState from;
  from.motion = sticking.at_section;
  from.motion.q = start.q;
  from.motion.qdot = start.qdot;
  from.streaks.resize(found.system.stops.size());
  from.closure_speed = sticking.closure_speed;
  from.started = true;
  SimulationOptions options;
  options.duration = sticking.at_section.instant.local + found.orbit.period * found.system.period();
  return resume(found.system, from, options).final;
}

std::vector<int> closed_at_section(const Orbit& orbit) {
  std::vector<int> closed;
  const auto& contacts = orbit.sticking->at_section.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i] == Contact::kClosed) closed.push_back(static_cast<int>(i));
  return closed;
}

// Eigenvalues of the map on the held motion's coordinates, by central differences.
std::vector<Eigenvalue> differenced_multipliers(const Found& found) {
  const ContactPhase<double> phase(found.system, closed_at_section(found.orbit));
  const Matrix basis = phase.basis();
  const Eigen::Index m = basis.cols();
  const ShootingScale scale = shooting_scale(found.system);
  const MotionState<double>& at = found.orbit.sticking->at_section;
  Vector unit(2 * m);
  unit << Vector::Constant(m, scale.displacement),
      scale.displacement * phase.reduced().omega.cwiseMax(found.system.forcing->frequency);
  const auto map = [&](const Vector& z) {
    const Vector x = z.cwiseProduct(unit);
    const State end = simulated(found, {at.q + basis * x.head(m), at.qdot + basis * x.tail(m)});
    Vector y(2 * m);
    y << basis.transpose() * (end.q - at.q), basis.transpose() * (end.qdot - at.qdot);
    return Vector(y.cwiseQuotient(unit));
  };
  return eigenvalues(
      support::central_jacobian(map, Vector::Zero(2 * m), Vector::Constant(2 * m, 1e-4)));
}

void expect_multipliers(const Scene& scene, int zeros) {
  SCOPED_TRACE(scene.title);
  const Found found = settled_orbit(scene);
  ASSERT_TRUE(found.orbit.sticking);
  EXPECT_EQ(static_cast<int>(found.orbit.multipliers.size()), 2 * found.system.modes());
  EXPECT_EQ(exact_zeros(found.orbit), zeros);
  EXPECT_LE(found.orbit.residual, 1e-13);
  const std::vector<Eigenvalue> expected = differenced_multipliers(found);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LE(std::abs(found.orbit.multipliers[i].value - expected[i].value), 1e-8) << i;
  }
}

TEST(StickingOrbit, MultipliersAreThoseOfTheSimulatedMap) {
  for (const char* name : {"rayl3", "gravity2", "plastic", "defect", "defect3", "ratio2", "ratio3"})
    expect_multipliers(sticking_case(name), 2);
  expect_multipliers(sticking_case("two_stops3"), 4);
  // Unequal damping ratios: complex modes while held.
  for (const char* settings : {"1.1", "0.9"})
    expect_multipliers(sticking_case("ratio3", {"forcing.frequency=" + std::string(settings),
                                                "stop.restitution=0.2"}),
                       2);
  // r(v)
  expect_multipliers(sticking_case("rayl3", {"stop.restitution=[0.65, 0.3]"}), 2);
}

TEST(StickingOrbit, MultipliersOfBeams) {
  expect_multipliers(beam("momentum", 2, 24.0), 2);
  expect_multipliers(beam("momentum", 3, 18.0), 2);
  expect_multipliers(beam("momentum", 3, 24.0), 2);
  expect_multipliers(beam("collocation", 2, 24.0), 2);
  expect_multipliers(beam("collocation", 3, 44.0), 2);
}

// ---------------------------------------------------------------- the map in 50 digits

using Real = Extended;

RealVector<Real> extended_map(const Found& found, const MotionState<Real>& from,
                              const RealVector<Real>& dq, const RealVector<Real>& dqdot,
                              const Real& closure_speed) {
  MotionState<Real> start = from;
  start.q += dq;
  start.qdot += dqdot;
  Motion<Real> motion(found.system, start);
  const Instant<Real> end{from.instant.period + found.orbit.period, from.instant.local};
  for (;;) {
    const Instant<Real> now = motion.instant();
    const bool last = now.period == end.period;
    if (!motion.has_news() && last && now.local >= end.local) break;
    const Real until = motion.has_news() ? now.local : last ? end.local : motion.flow().period();
    const Arrival<Real> arrival = motion.fly(until);
    if (arrival.kind == ArrivalKind::kUndecided || arrival.kind == ArrivalKind::kRefused ||
        arrival.kind == ArrivalKind::kNotFinite) {
      ADD_FAILURE() << "the motion cannot be followed";
      break;
    }
    if (arrival.kind != ArrivalKind::kContact) continue;
    const std::vector<ImpactShare<Real>> shares = motion.impact();
    if (shares.size() == 1 && arrival.speed <= closure_speed)
      motion.close_chatter(
          arrival.stop,
          found.system.stops[static_cast<std::size_t>(arrival.stop)].restitution.at(arrival.speed));
  }
  RealVector<Real> state(2 * dq.size());
  state << motion.q(), motion.qdot();
  return state;
}

// Eigenvalues of the map of the held coordinates: central differences whose error, of the order of
// the square of their step, is below 1e-20.
std::vector<Eigenvalue> extended_multipliers(const Found& found, const Real& closure_speed) {
  const MotionState<double>& at = found.orbit.sticking->at_section;
  const MotionState<Real> from{{at.instant.period, Real(at.instant.local)},
                               at.q.cast<Real>(),
                               at.qdot.cast<Real>(),
                               at.contacts,
                               at.multiplicities};
  const ContactPhase<double> phase(found.system, closed_at_section(found.orbit));
  const RealMatrix<Real> basis = phase.basis().cast<Real>();
  const Eigen::Index n = basis.rows(), m = basis.cols();
  const Real step = 1e-12 * shooting_scale(found.system).displacement;
  Matrix map(2 * m, 2 * m);
  for (Eigen::Index column = 0; column < 2 * m; ++column) {
    RealVector<Real> dq = RealVector<Real>::Zero(n), dqdot = dq;
    (column < m ? dq : dqdot) = basis.col(column % m) * step;
    const RealVector<Real> change = extended_map(found, from, dq, dqdot, closure_speed) -
                                    extended_map(found, from, -dq, -dqdot, closure_speed);
    RealVector<Real> reduced(2 * m);
    reduced << basis.transpose() * change.head(n), basis.transpose() * change.tail(n);
    map.col(column) = RealVector<Real>(reduced / (2 * step)).cast<double>();
  }
  // Velocities in units of the frequencies of the held structure, as the orbit has them.
  Vector unit(2 * m);
  unit << Vector::Ones(m), phase.reduced().omega.cwiseMax(found.system.forcing->frequency);
  return eigenvalues(unit.cwiseInverse().asDiagonal() * map * unit.asDiagonal());
}

TEST(StickingOrbit, MultipliersAreThoseOfFiftyDigits) {
  for (const Scene& scene : {sticking_case("rayl3"), sticking_case("gravity2"),
                             sticking_case("plastic"), beam("momentum", 2, 24.0)}) {
    SCOPED_TRACE(scene.title);
    // Chatters followed so far that closing them is below rounding: short flights cost no digits.
    const Found found = settled_orbit(scene, 1e-9 * shooting_scale(assemble(scene)).length);
    const std::vector<Eigenvalue> expected =
        extended_multipliers(found, Real(1e-12) * shooting_scale(found.system).length);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_LE(std::abs(found.orbit.multipliers[i].value - expected[i].value), 1e-12) << i;
  }
}

// ---------------------------------------------------------------- what closing a chatter costs

TEST(StickingOrbit, ClosingAChatterCostsPowersOfItsSpeed) {
  const Scene scene = sticking_case("rayl3");
  const Found fine = settled_orbit(scene, 1e-8);
  // Of the accumulation, of the release, of the largest multiplier.
  const auto miss = [&](double speed) {
    const Found coarse = settled_orbit(scene, speed);
    const OrbitHold &a = coarse.orbit.sticking->holds.front(),
                    &b = fine.orbit.sticking->holds.front();
    return std::array<double, 3>{
        turned(a.from.phase, b.from.phase), turned(a.to.phase, b.to.phase),
        std::abs(coarse.orbit.multipliers[0].value - fine.orbit.multipliers[0].value)};
  };
  // The last resolved impact jumps between two speeds: means over one factor r at either end.
  const auto mean = [&](double speed) {
    std::array<double, 3> sum{};
    for (int k = 0; k < 8; ++k) {
      const std::array<double, 3> one = miss(speed * std::pow(0.65, k / 8.0));
      for (std::size_t i = 0; i < 3; ++i) sum[i] += std::log(one[i]) / 8.0;
    }
    return sum;
  };
  const std::array<double, 3> coarse = mean(1e-2), finer = mean(1e-3);
  const std::array<double, 3> expected = {2.0, 3.0, 3.0};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR((coarse[i] - finer[i]) / std::log(10.0), expected[i], 0.1) << i;
}

// ---------------------------------------------------------------- the search

// The state of an orbit at the start of a forcing period.
State at_period_start(const Found& found) {
  const MotionState<double>& section = found.orbit.sticking->at_section;
  RunState from;
  from.motion = section;
  from.streaks.resize(found.system.stops.size());
  from.closure_speed = found.orbit.sticking->closure_speed;
  from.started = true;
  return resume(found.system, from, support::for_periods(section.instant.period + 1)).final;
}

StickingOrbitAnswer search_from(const Found& found, const State& guess, int period) {
  return sticking_orbit(found.system, guess, period,
                        {found.orbit.sticking->closure_speed, 10'000'000, {}});
}

TEST(StickingOrbit, IsFoundFromARoughGuess) {
  support::Dice dice(7);
  for (const Scene& scene : {sticking_case("rayl3"), sticking_case("gravity2"),
                             beam("momentum", 2, 24.0), beam("collocation", 3, 44.0)}) {
    SCOPED_TRACE(scene.title);
    const Found found = settled_orbit(scene);
    const State start = at_period_start(found);
    const ShootingScale scale = shooting_scale(found.system);
    for (const double off : {1e-6, 1e-4}) {
      State guess = start;
      for (Eigen::Index j = 0; j < guess.q.size(); ++j) {
        guess.q[j] += off * scale.displacement * dice.uniform(-1.0, 1.0);
        guess.qdot[j] += off * scale.velocity[j] * dice.uniform(-1.0, 1.0);
      }
      const StickingOrbitAnswer answer = search_from(found, guess, found.orbit.period);
      ASSERT_TRUE(answer.orbit) << off << ": " << answer.why_not;
      EXPECT_LE(answer.orbit->residual, 1e-13);
      ASSERT_FALSE(answer.orbit->sticking->holds.empty());
      EXPECT_LE(turned(answer.orbit->sticking->holds.front().to.phase,
                       found.orbit.sticking->holds.front().to.phase),
                1e-11);
    }
  }
}

TEST(StickingOrbit, IsListedWithItsShortestPeriod) {
  const Found one = settled_orbit(sticking_case("rayl3"));
  const StickingOrbitAnswer again = search_from(one, at_period_start(one), 4);
  ASSERT_TRUE(again.orbit) << again.why_not;
  EXPECT_EQ(again.orbit->period, 1);
  EXPECT_EQ(again.orbit->impacts.size(), one.orbit.impacts.size());
  const Found two = settled_orbit(beam("momentum", 3, 24.0));
  EXPECT_EQ(two.orbit.period, 2);
  const StickingOrbitAnswer twice = search_from(two, at_period_start(two), 4);
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
TEST(StickingOrbit, OfOneModeForgetsEveryStart) {
  const Found found = settled_orbit(sticking_case("Z2c"));
  for (const double q : {0.15, 0.1, -0.05})
    for (const double qdot : {0.0, 0.02}) {
      const StickingOrbitAnswer answer = search_from(found, support::state_of({q}, {qdot}), 2);
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
TEST(StickingOrbit, ThatIsUnstableIsFoundFromItsNeighbour) {
  const Found stable = settled_orbit(beam("momentum", 2, 24.0));
  EXPECT_EQ(stable.orbit.stable, std::optional<bool>(true));
  Found unstable{assemble(beam("momentum", 2, 24.1)), {}};
  const StickingOrbitAnswer answer =
      sticking_orbit(unstable.system, at_period_start(stable), 1,
                     {stable.orbit.sticking->closure_speed, 10'000'000, {}});
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
TEST(StickingOrbit, ClearanceKnowsNothingOfTheReleaseItself) {
  for (const double frequency : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
    SCOPED_TRACE(frequency);
    const Found found = settled_orbit(sticking_case(
        "ratio3", {"forcing.frequency=" + std::to_string(frequency), "stop.restitution=0.2"}));
    EXPECT_GT(found.orbit.clearance.value_or(1.0), 1e-9);
    EXPECT_TRUE(found.orbit.admissible);
  }
}

TEST(StickingOrbit, SaysWhyThereIsNone) {
  StickingOptions options;
  options.closure_speed = 1e-6;
  // Pressed onto its stop for ever.
  const System held = support::forced_oscillator(1.0, 0.0, -0.2, 0.7, 1.3, 0.1);
  const StickingOrbitAnswer rest =
      sticking_orbit(held, support::state_of({-0.2}, {0.0}), 1, options);
  EXPECT_FALSE(rest.orbit);
  EXPECT_NE(rest.why_not.find("without any impact"), std::string::npos) << rest.why_not;
  // Far from its stop.
  const System free = support::forced_oscillator(1.0, 0.1, 50.0, 0.7, 1.3, 0.1);
  const StickingOrbitAnswer clear =
      sticking_orbit(free, support::state_of({0.0}, {0.0}), 3, options);
  EXPECT_FALSE(clear.orbit);
  EXPECT_NE(clear.why_not.find("no stop is closed within 3"), std::string::npos) << clear.why_not;
  // Two equal oscillators, side by side, each with its stop: hit at the same instants.
  System pair = support::forced_oscillator(1.0, 0.0, 0.2, 0.2, 0.5, 1.0);
  pair.omega = Vector::Ones(2);
  pair.delta = Vector::Zero(2);
  pair.forcing->amplitude = Vector::Ones(2);
  pair.stops[0].row = pair.stops[0].direction = Vector::Unit(2, 0);
  pair.stops.push_back(pair.stops[0]);
  pair.stops[1].row = pair.stops[1].direction = Vector::Unit(2, 1);
  const StickingOrbitAnswer both =
      sticking_orbit(pair, support::state_of({0.2, 0.2}, {0.0, 0.0}), 1, options);
  EXPECT_FALSE(both.orbit);
  EXPECT_NE(both.why_not.find("one instant"), std::string::npos) << both.why_not;
}

}  // namespace
}  // namespace graze
