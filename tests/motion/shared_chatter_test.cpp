// Chatter that two stops share: thrown off one, the structure meets the other.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/detail/shared_chatter.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::for_seconds;
using support::record_run;
using support::RecordedRun;
using support::state_of;

constexpr double kChatterGravity = 9.81;

// A rigid bar that falls (q1) and turns (q2) onto supports at +s and -s, the second lower by `gap`:
// unit mass and moment of inertia. Rows (1, +-s): an impulse on one support that undoes the speed v
// there throws the bar off the other at D v, D = (1 - s^2)/(1 + s^2).
System bar(double s, double gap, double restitution) {
  System system{Vector::Zero(2), NaturalModes{Vector::Zero(2)}, {}};
  system.modal().load = Vector{{kChatterGravity, 0.0}};
  for (const double side : {s, -s}) {
    const Vector row{{1.0, side}};
    system.stops.push_back(
        {row, side > 0 ? 0.0 : gap, ImpactLaw{momentum_direction(row), Restitution(restitution)}});
  }
  return system;
}

// A bar that does not rebound rocks to rest: resting on one support, it falls onto the other within
// t, is thrown off the first at D times the speed it came with, and so on; each fall back takes
// twice D times the fall before it, in all t (1 + D)/(1 - D).
TEST(SharedChatter, OfARockingBarEndsAtTheSumOfItsSeries) {
  for (const double s : {0.2, 0.5, 0.7, 0.9}) {
    SCOPED_TRACE(testing::Message() << "supports at +-" << s);
    const double gap = 1e-3, ratio = (1.0 - s * s) / (1.0 + s * s);
    const System system = bar(s, gap, 0.0);
    const RecordedRun run = record_run(system, support::rest(system), for_seconds(20.0));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
    EXPECT_EQ(run.result.stuck, (std::vector<int>{0, 1}));
    const double fall = std::sqrt(2.0 * gap / (kChatterGravity * (1.0 - ratio)));
    EXPECT_NEAR(run.events.back().time, fall * (1.0 + ratio) / (1.0 - ratio), 1e-9 * fall);
    // Of symmetry each support carries half of the weight; the force is in units of |row|^2.
    for (const double force : run.result.forces)
      EXPECT_NEAR(force, 0.5 * kChatterGravity, 1e-12 * kChatterGravity);
    // All of the height is lost: the bar ends lower at its middle by half of the gap.
    EXPECT_NEAR(run.result.totals.energy_lost, 0.5 * kChatterGravity * gap,
                1e-13 * kChatterGravity * gap);
    EXPECT_LT(run.result.totals.impacts, 2000);
  }
}

// Supports so near that hardly anything is lost from impact to impact: the tail has tens of
// thousands of them, and a look at it that finds no end is not repeated at every one.
TEST(SharedChatter, OfABarOnNearSupportsEnds) {
  for (const double restitution : {0.5, 0.8, 0.9, 0.95}) {
    System system = bar(0.1, 0.1, restitution);
    system.stops[0].gap = 0.1;
    const RecordedRun run =
        record_run(system, state_of({0.0, 0.0}, {0.1, 0.05}), for_seconds(60.0));
    EXPECT_EQ(run.result.stuck, (std::vector<int>{0, 1})) << "r = " << restitution;
    EXPECT_LT(run.result.totals.impacts, 100'000) << "r = " << restitution;
    // At rest 0.1 m lower all that it had is lost.
    EXPECT_NEAR(run.result.totals.energy_lost, 0.5 * (0.01 + 0.0025) + kChatterGravity * 0.1, 1e-9);
  }
}

TEST(SharedChatter, OfARockingBarTakesTheTimeOfItsSeries) {
  const double ratio = 0.6, speed = 1e-3;
  // Resting on the first, just thrown off the second.
  const Matrix rows{{1.0, ratio}, {0.0, std::sqrt(1.0 - ratio * ratio)}};
  SharedChatter chatter{rows,
                        rows,
                        Vector::Zero(2),
                        Vector{{0.0, -speed}},
                        Vector{{kChatterGravity, kChatterGravity}},
                        {Restitution(0.0), Restitution(0.0)}};
  const double fall = 2.0 * speed / (kChatterGravity * (1.0 - ratio));
  const std::optional<double> duration = time_to_rest(chatter, 1.1 * speed);
  ASSERT_TRUE(duration);
  EXPECT_NEAR(*duration, fall / (1.0 - ratio), 2e-6 * fall);
  EXPECT_FALSE(time_to_rest(chatter, 0.9 * speed)) << "it comes down at `speed`";
  chatter.pushes = Vector{{kChatterGravity, -kChatterGravity}};
  EXPECT_FALSE(time_to_rest(chatter, 1.1 * speed)) << "the second is pulled away from";
}

// The paper's beam under its own weight on two supports that throw it off each other.
Scene supported_beam(int modes, double restitution, const std::string& law = "momentum") {
  std::string text =
      "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
      "density = 8500.0\narea = 12.4e-6\nmodes = " +
      std::to_string(modes) + "\n[damping]\nviscous = 0.005\n[gravity]\nacceleration = 9.81\n";
  for (const char* place : {"position = 0.3\ngap = 1e-3\n", "position = 0.2\ngap = 0.5e-3\n"})
    text += std::string("[[stop]]\n") + place + "restitution = " + std::to_string(restitution) +
            "\nimpulse = \"" + law + "\"\n";
  return parse_scene(text, "supported beam");
}

TEST(SharedChatter, OfABeamOnTwoSupportsEnds) {
  for (const double restitution : {0.1, 0.5, 0.8, 0.95}) {
    SCOPED_TRACE(testing::Message() << "r = " << restitution);
    const Scene scene = supported_beam(2, restitution);
    const System system = assemble(scene);
    SimulationOptions options = for_seconds(3.0);
    options.energy = true;
    const RecordedRun run = record_run(system, initial_state(scene, system), options);
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    EXPECT_EQ(run.result.stuck, (std::vector<int>{0, 1}));
    EXPECT_LT(run.result.totals.impacts, 20'000);
    EXPECT_LE(std::abs(run.result.energy->defect()), 1e-12 * run.result.energy->size());
    // Two modes on two supports: at rest where static balance has them.
    Matrix rows(2, 2), directions(2, 2);
    Vector gaps(2);
    for (int i = 0; i < 2; ++i) {
      rows.col(i) = system.stops[static_cast<std::size_t>(i)].row;
      gaps[i] = system.stops[static_cast<std::size_t>(i)].gap;
    }
    const Vector q = rows.transpose().inverse() * gaps;
    EXPECT_LE((run.result.final.q - q).norm(), 1e-14 * q.norm());
    const Vector forces =
        rows.inverse() * (*system.load() - system.omega.cwiseAbs2().cwiseProduct(q));
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(run.result.forces[static_cast<std::size_t>(i)], forces[i], 1e-11 * forces.norm());
  }
}

TEST(SharedChatter, ErrsBySecondOrderInItsSpeed) {
  for (const int modes : {3, 4}) {
    const Scene scene = supported_beam(modes, 0.5);
    const System system = assemble(scene);
    const auto end = [&](double speed) {
      SimulationOptions options = for_seconds(1.0);
      options.closure_speed = speed;
      const RecordedRun run = record_run(system, initial_state(scene, system), options);
      EXPECT_EQ(run.result.stuck, (std::vector<int>{0, 1}));
      return run.result.final.q;
    };
    const Vector exact = end(1e-7);
    const double coarse = (end(1e-3) - exact).norm(), middle = (end(1e-4) - exact).norm(),
                 fine = (end(1e-5) - exact).norm();
    // A hundredth each, but for the number of impacts that fall below the speed.
    EXPECT_LE(middle, coarse / 20.0) << "N = " << modes;
    EXPECT_LE(fine, middle / 20.0) << "N = " << modes;
    EXPECT_GT(coarse, 1e-6 * exact.norm()) << "nothing was summed";
  }
}

// A plucked string that lays itself onto frets without rebound. Whatever meets a fret pushes the
// string off others that held it, which it comes back to a hundred times more slowly.
System string_over_frets(int modes, int frets, double restitution) {
  System system{Vector(modes), NaturalModes{Vector(modes)}, {}};
  for (int j = 1; j <= modes; ++j) {
    system.omega[j - 1] = 600.0 * j;
    system.modal().delta[j - 1] = 2e-4 * system.omega[j - 1];
  }
  for (int k = 1; k <= frets; ++k) {
    Vector row(modes);
    for (int j = 1; j <= modes; ++j) row[j - 1] = -std::sqrt(2.0) * std::sin(j * M_PI * 0.04 * k);
    system.stops.push_back(
        {row, 6e-4, ImpactLaw{momentum_direction(row), Restitution(restitution)}});
  }
  return system;
}
State plucked(int modes, double height, double place) {
  Vector q(modes);
  for (int j = 1; j <= modes; ++j)
    q[j - 1] = height * std::sqrt(2.0) * std::sin(j * M_PI * place) /
               (j * j * M_PI * M_PI * place * (1.0 - place));
  return {q, Vector::Zero(modes)};
}

TEST(SharedChatter, OfAStringOnItsFretsIsSummedAtItsFirstSlowImpacts) {
  const System system = string_over_frets(40, 10, 0.0);
  const State start = plucked(40, 1e-2, 0.7);
  const double quickest = (system.omega.cwiseProduct(start.q)).norm();  // m/s
  const auto run_at = [&](double speed) {
    SimulationOptions options = for_seconds(0.01);
    options.closure_speed = speed;
    RecordedRun run = record_run(system, start, options);
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    return run;
  };
  const Vector exact = run_at(1e-9).result.final.q;
  for (const double speed : {1e-3, 1e-4, 1e-5}) {
    SCOPED_TRACE(testing::Message() << "closure speed " << speed << " m/s");
    const RecordedRun run = run_at(speed);
    const auto slow = std::count_if(run.events.begin(), run.events.end(), [&](const Event& event) {
      return event.kind == EventKind::kImpact && event.speed < speed;
    });
    EXPECT_GT(run.result.totals.chatters, 0);
    EXPECT_LE(slow, run.result.totals.chatters);
    // What is summed errs by second order.
    EXPECT_LE((run.result.final.q - exact).norm(), std::pow(speed / quickest, 2) * exact.norm());
  }
}

TEST(SharedChatter, EndsWhateverSpeedIsAskedFor) {
  // Falls of less than the rounding of the gaps cannot be followed.
  const Scene scene = supported_beam(2, 0.8);
  const System system = assemble(scene);
  SimulationOptions options = for_seconds(0.3);
  options.closure_speed = 1e-30;
  const RecordedRun run = record_run(system, initial_state(scene, system), options);
  EXPECT_EQ(run.result.stuck, (std::vector<int>{0, 1}));
  EXPECT_LT(run.result.totals.impacts, 20'000);
}

TEST(SharedChatter, IsCutAndResumedToTheSameBits) {
  const Scene scene = supported_beam(3, 0.6);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const RecordedRun whole = record_run(system, start, for_seconds(1.2));
  ASSERT_EQ(whole.result.stuck, (std::vector<int>{0, 1}));
  for (std::size_t k = whole.events.size() - 6; k < whole.events.size(); ++k) {
    const Simulation first = simulate(system, start, for_seconds(whole.events[k].time));
    const Simulation second = resume(system, first.state, for_seconds(1.2));
    EXPECT_EQ(second.final.q, whole.result.final.q) << k;
    EXPECT_EQ(second.totals.chatters, whole.result.totals.chatters) << k;
  }
}

}  // namespace
}  // namespace graze
