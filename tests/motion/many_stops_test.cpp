// Many stops touched at one instant, and many modes over many stops.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// A body of `count` free masses, each with a stop 1 m ahead of it, all met after 1 s; masses touch
// one another through stops that see two of them where `coupled`.
System masses_before_stops(int count, double restitution, bool coupled) {
  System system{Vector::Zero(count), NaturalModes{Vector::Zero(count)}, {}};
  for (int i = 0; i < count; ++i) {
    Vector row = Vector::Unit(count, i);
    if (coupled && i > 0) row[i - 1] = 0.25;
    system.stops.push_back({row, row.sum(), ImpactLaw{momentum_direction(row), restitution}});
  }
  return system;
}

TEST(ManyStops, AHundredAreHitAtOnce) {
  for (const double r : {0.0, 0.5, 1.0}) {
    const int count = 100;
    const System system = masses_before_stops(count, r, false);
    Motion<double> motion(system, {}, Vector::Zero(count), Vector::Ones(count));
    const Arrival<double> arrival = motion.fly(2.0);
    ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
    EXPECT_EQ(arrival.flight, 1.0);
    const std::vector<ImpactShare<double>> shares = motion.impact();
    EXPECT_EQ(shares.size(), 100U);
    for (int i = 0; i < count; ++i) EXPECT_NEAR(motion.qdot()[i], -r, 1e-15);
  }
}

// Each pushes its neighbour: p >= 0, v+ + r v- <= 0, one of them zero.
TEST(ManyStops, SixtyThatPushEachOtherShareTheImpactOut) {
  const int count = 60;
  const System system = masses_before_stops(count, 0.5, true);
  Motion<double> motion(system, {}, Vector::Zero(count), Vector::Ones(count));
  const Arrival<double> arrival = motion.fly(2.0);
  ASSERT_EQ(arrival.kind, ArrivalKind::kContact);
  EXPECT_NEAR(arrival.flight, 1.0, 1e-15);
  const Vector before = motion.qdot();
  const std::vector<ImpactShare<double>> shares = motion.impact();
  ASSERT_EQ(shares.size(), 60U);
  Vector undone = Vector::Zero(count);
  for (const ImpactShare<double>& share : shares) {
    const Stop& stop = system.stops[static_cast<std::size_t>(share.stop)];
    EXPECT_GE(share.impulse, 0.0);
    undone += share.impulse * stop.direction();
    const double left = stop.row.dot(motion.qdot()) + 0.5 * stop.row.dot(before);
    EXPECT_LE(left, 1e-14);
    EXPECT_NEAR(left * share.impulse, 0.0, 1e-14);
  }
  EXPECT_LE((before - undone - motion.qdot()).norm(), 1e-14);
  EXPECT_LT(motion.qdot().squaredNorm(), before.squaredNorm());
}

// Stops that leave no room: the sentence says why the motion ends.
TEST(ManyStops, BetweenFacingStopsNothingMoves) {
  const int count = 14;
  System system = masses_before_stops(count, 0.5, false);
  const std::vector<Stop> ahead = system.stops;
  for (const Stop& stop : ahead)
    system.stops.push_back({-stop.row, -1.0, ImpactLaw{momentum_direction(-stop.row), 0.5}});
  Motion<double> motion(system, {}, Vector::Ones(count), Vector::Zero(count));
  const Arrival<double> arrival = motion.fly(1.0);
  EXPECT_TRUE(arrival.kind == ArrivalKind::kTime || !motion.refusal().empty() ||
              arrival.kind == ArrivalKind::kStick || arrival.kind == ArrivalKind::kTouch);
  EXPECT_EQ(motion.qdot().norm(), 0.0);
}

// Two stops that face each other without room: impacts at one instant, which none but the next
// answers. Whether they come to rest is of no interest, and not followed to its end each time (some
// thirty thousand impacts, or without a loss 65536; in all a hundred times the bound).
TEST(ManyStops, WithoutRoomImpactsAreNotFollowedToTheirEnd) {
  for (const double restitution : {0.999, 1.0}) {
    System system = support::oscillator(1.0, 0.05, 0.0, restitution);
    const Vector back = -system.stops[0].row;
    system.stops.push_back({back, 0.0, ImpactLaw{momentum_direction(back), restitution}});
    const auto begin = std::chrono::steady_clock::now();
    for (int run = 0; run < 40; ++run) {
      Motion<double> motion(system, {}, Vector::Zero(1), Vector::Ones(1));
      for (int i = 1; i <= 1000; ++i) {
        ASSERT_EQ(motion.fly(1.0).kind, ArrivalKind::kContact) << i;
        motion.impact();
        ASSERT_NEAR(std::abs(motion.qdot()[0]), std::pow(restitution, i), 1e-12);
      }
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  }
}

// A plucked string of many modes over a row of stops: the balance closes through impacts, chatters
// and holds, and a run that was cut goes on bit for bit.
System plucked_string(int modes, int stops, double restitution) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  for (int j = 0; j < modes; ++j) {
    const double n = j + 1.0;
    system.omega[j] = n * std::sqrt(1.0 + 1e-4 * n * n);
    system.modal().delta[j] = (1e-4 + 1e-6 * n * n) * system.omega[j] * (j % 2 == 0 ? 1.0 : 2.0);
  }
  for (int i = 0; i < stops; ++i) {
    Vector row(modes);
    const double x = 0.1 + 2.2 * i / stops;
    for (int j = 0; j < modes; ++j) row[j] = std::sin((j + 1.0) * x);
    system.stops.push_back({row, 0.05 + 0.01 * i, ImpactLaw{momentum_direction(row), restitution}});
  }
  return system;
}

State triangle(int modes, double place) {
  State start{Vector(modes), Vector::Zero(modes)};
  for (int j = 0; j < modes; ++j)
    start.q[j] = -0.4 * std::sin((j + 1.0) * place) * std::pow(j + 1.0, -2.0);
  return start;
}

class ManyModes : public testing::TestWithParam<double> {};

TEST_P(ManyModes, TheBalanceCloses) {
  const System system = plucked_string(120, 8, GetParam());
  SimulationOptions options = support::for_seconds(4.0);
  options.energy = true;
  const Simulation run = simulate(system, triangle(120, 2.1), options);
  ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd) << run.message;
  EXPECT_GT(run.totals.impacts, 10);
  const EnergyBalance& balance = *run.energy;
  EXPECT_NEAR(balance.start + balance.impacts - balance.work.dissipation, balance.now,
              1e-11 * balance.start);
  EXPECT_GE(*run.totals.smallest_gap, 0.0);
  if (GetParam() == 0.0) {
    EXPECT_GT(run.totals.stuck_time, 0.0);
  }
}

// Mode by mode, what the stops have given is what its motion has changed by:
//   [q_j'] + 2 delta_j [q_j] + w_j^2 T mean(q_j) + sum_i b_ij J_i = 0,
// [..] from the start to the end after T.
TEST_P(ManyModes, TheStopsGiveWhatTheModesTake) {
  const System system = plucked_string(120, 8, GetParam());
  const State start = triangle(120, 2.1);
  const std::vector<int> modes{0, 1, 7, 60, 119};
  SimulationOptions options = support::for_seconds(4.0);
  options.measure = MeasureOptions{{}, 0.0, ForceWindows{0.05, 80}};
  for (const int j : modes)
    options.measure->rows.push_back({Vector::Unit(system.modes(), j), false});
  const Simulation run = simulate(system, start, options);
  ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd);
  const Amplitudes& found = *run.amplitudes;
  double held = 0.0;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const int j = modes[k];
    const double w = system.omega[j];
    const double terms[] = {run.final.qdot[j] - start.qdot[j],
                            2.0 * system.modal().delta[j] * (run.final.q[j] - start.q[j]),
                            w * w * found.duration * found.rows[k].mean};
    double sum = terms[0] + terms[1] + terms[2], size = 0.0;
    for (const double term : terms) size += std::abs(term);
    for (std::size_t i = 0; i < system.stops.size(); ++i) {
      const double given = system.stops[i].row[j] * found.stops[i].impulse;
      sum += given;
      size += std::abs(given);
    }
    EXPECT_NEAR(sum, 0.0, 1e-9 * size) << "mode " << j + 1;
  }
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    double impulse = 0.0;
    for (const double mean : found.forces->means[i]) impulse += 0.05 * mean;
    EXPECT_NEAR(impulse, found.stops[i].impulse, 1e-12 * found.stops[i].impulse) << i;
    held = std::max(held, found.stops[i].held);
  }
  EXPECT_LE(held, run.totals.stuck_time);
  EXPECT_EQ(held > 0.0, run.totals.stuck_time > 0.0);
}

TEST_P(ManyModes, ARunThatWasCutGoesOnBitForBit) {
  const System system = plucked_string(100, 6, GetParam());
  const State start = triangle(100, 2.1);
  const Simulation whole = simulate(system, start, support::for_seconds(3.0));
  ASSERT_EQ(whole.outcome, RunOutcome::kReachedEnd) << whole.message;
  const Simulation part = simulate(system, start, support::for_seconds(1.7));
  const Simulation rest = resume(system, part.state, support::for_seconds(3.0));
  EXPECT_EQ(rest.final.q, whole.final.q);
  EXPECT_EQ(rest.final.qdot, whole.final.qdot);
  EXPECT_EQ(rest.totals.impacts, whole.totals.impacts);
}

INSTANTIATE_TEST_SUITE_P(Restitutions, ManyModes, testing::Values(0.0, 0.9, 1.0));

// Six undamped modes that lie on one stop hit another without loss nine hundred times. Whatever
// rounding does there to the structure held on the first may not grow from impact to impact.
TEST(ManyStops, ImpactsBesideAClosedStopKeepTheEnergy) {
  const Scene scene = parse_scene(R"(
[modal]
frequencies = [4.2, 4.8, 1.4, 4.0, 4.8, 2.8]
inertia = [0.51, 0.3, -0.79, 0.38, 0.24, -0.62]
[[stop]]
shape = [-0.043, -1.742720161639644, 0.53, -2.3, 0.85, -1.2]
gap = 0.021
restitution = 1.0
[[stop]]
shape = [0.58, 0.047, -0.6231237340064424, 0.5867277851830484, -0.642998074753107, 0.55822]
gap = -0.4661958643238651
restitution = 0.26
[initial]
q = [-0.23923813550699619, 0.23832556036353902, 0.21521990084344478, 0.0056, 0.23274495704839127,
     -0.10546219966241051]
qdot = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
)",
                                  "beside a closed stop");
  const System system = assemble(scene);
  SimulationOptions options;
  options.duration = 44.88;
  options.energy = true;
  const Simulation run = simulate(system, initial_state(scene, system), options);
  EXPECT_GT(run.totals.impacts, 500);
  EXPECT_GT(run.totals.stuck_time, 40.0);
  EXPECT_LT(std::abs(run.energy->defect()), 1e-11 * run.energy->size());
}

}  // namespace
}  // namespace graze
