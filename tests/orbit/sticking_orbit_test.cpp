// Orbits that stick: events against 60-digit runs, multipliers against central differences of the
// simulated map and against the same map in 50 digits, the price of closing a chatter.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/system/scale.hpp"
#include "orbit/settled_sticking_orbit.hpp"

namespace graze {
namespace {

using support::number;
using support::TableRow;

// ---------------------------------------------------------------- events

// tests/reference/sticking_motion.csv: 60 digits, every chatter followed to its end. Its last full
// period comes after the motion has stuck, and so lies on the orbit to the modulus of the largest
// multiplier.
void expect_listed_events(const std::string& name, const std::vector<TableRow>& rows,
                          double tolerance) {
  SCOPED_TRACE(name);
  const Found found = settled_orbit(sticking_case(name));
  const Orbit& orbit = found.orbit;
  ASSERT_TRUE(orbit.sticks());
  ASSERT_EQ(orbit.period, 1);
  const double period = found.system.period(), end = number(rows.back(), "time");
  std::size_t impacts = 0, sticks = 0, releases = 0;
  for (const TableRow& row : rows) {
    const double time = number(row, "time");
    if (!(time > end - period)) continue;
    const int stop = static_cast<int>(number(row, "stop")) - 1;
    const double phase = found.system.forcing()->frequency * time + found.system.forcing()->phase;
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
    for (const StickingPhase& sticking : orbit.sticking) {
      if (row.at("kind") == "stick") consider(sticking.stop, sticking.from.phase, 0.0);
      if (row.at("kind") == "release") consider(sticking.stop, sticking.to.phase, 0.0);
    }
    sticks += row.at("kind") == "stick";
    releases += row.at("kind") == "release";
    EXPECT_LE(nearest, tolerance) << "row " << row.at("event");
    EXPECT_LE(std::abs(speed_miss), tolerance) << "row " << row.at("event");
  }
  EXPECT_EQ(sticks, orbit.sticking.size());
  EXPECT_EQ(releases, orbit.sticking.size());
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

void expect_multipliers(const Scene& scene, int zeros) {
  SCOPED_TRACE(scene.title);
  const Found found = settled_orbit(scene);
  ASSERT_TRUE(found.orbit.sticks());
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
    if (!motion.has_pending_events() && last && now.local >= end.local) break;
    const Real until = motion.has_pending_events() ? now.local
                       : last                      ? end.local
                                                   : motion.flow().period();
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
          arrival.stop, found.system.stops[static_cast<std::size_t>(arrival.stop)].restitution().at(
                            arrival.speed));
  }
  RealVector<Real> state(2 * dq.size());
  state << motion.q(), motion.qdot();
  return state;
}

// Eigenvalues of the map of the held coordinates: central differences whose error, of the order of
// the square of their step, is below 1e-20.
std::vector<Eigenvalue> extended_multipliers(const Found& found, const Real& closure_speed) {
  const MotionState<double>& at = found.orbit.section->states.front();
  const MotionState<Real> from{{at.instant.period, Real(at.instant.local)},
                               at.q.cast<Real>(),
                               at.qdot.cast<Real>(),
                               at.contacts,
                               at.multiplicities};
  const ConstrainedStructure<double> held(found.system, closed_at_section(found.orbit));
  const RealMatrix<Real> basis = held.basis.cast<Real>();
  const Eigen::Index n = basis.rows(), m = basis.cols();
  const Real step = 1e-12 * motion_scale(found.system).displacement;
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
  unit << Vector::Ones(m), held.reduced.omega.cwiseMax(found.system.forcing()->frequency);
  return eigenvalues(unit.cwiseInverse().asDiagonal() * map * unit.asDiagonal());
}

TEST(StickingOrbit, MultipliersAreThoseOfFiftyDigits) {
  for (const Scene& scene : {sticking_case("rayl3"), sticking_case("gravity2"),
                             sticking_case("plastic"), beam("momentum", 2, 24.0)}) {
    SCOPED_TRACE(scene.title);
    // Chatters followed so far that closing them is below rounding: short flights cost no digits.
    const Found found = settled_orbit(scene, 1e-9 * motion_scale(assemble(scene)).length);
    const std::vector<Eigenvalue> expected =
        extended_multipliers(found, Real(1e-12) * motion_scale(found.system).length);
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
    const StickingPhase &a = coarse.orbit.sticking.front(), &b = fine.orbit.sticking.front();
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

}  // namespace
}  // namespace graze
