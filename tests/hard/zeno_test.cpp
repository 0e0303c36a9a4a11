// Z1 to Z7: chatter, sticking and release. Expected values: closed forms, stated at each test.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/held/detail/constrained_structure.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/structure/detail/cantilever.hpp"
#include "support/reached.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::expect_reached;
using support::for_periods;
using support::for_seconds;
using support::off;
using support::oscillator;
using support::record_run;
using support::RecordedRun;
using support::relative;
using support::state_of;

int count(const RecordedRun& run, EventKind kind) {
  int events = 0;
  for (const Event& event : run.events) events += event.kind == kind;
  return events;
}

double time_of(const RecordedRun& run, EventKind kind, int which = 1) {
  for (const Event& event : run.events)
    if (event.kind == kind && --which == 0) return event.time;
  ADD_FAILURE() << "no such event";
  return std::nan("");
}

// A ball dropped from h on a floor comes to rest after sqrt(2 h/g) (1 + r)/(1 - r).
void expect_bouncing_ball(double drop, double gravity, double restitution) {
  SCOPED_TRACE(restitution);
  System system = oscillator(0.0, 0.0, drop, restitution);
  system.modal().load = Vector::Constant(1, gravity);
  const double rest = std::sqrt(2.0 * drop / gravity) * (1.0 + restitution) / (1.0 - restitution);
  const RecordedRun run = record_run(system, support::rest(system), for_seconds(1.5 * rest));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
  ASSERT_EQ(count(run, EventKind::kStick), 1);
  expect_reached("Z1", "bouncing ball, time to rest, relative",
                 relative(time_of(run, EventKind::kStick), rest), 1e-12);
  expect_reached("Z1", "penetration over the drop", -*run.result.totals.smallest_gap / drop, 1e-13);
  EXPECT_EQ(run.result.final.q[0], drop);
  EXPECT_EQ(run.result.final.qdot[0], 0.0);
  EXPECT_EQ(run.result.stuck, std::vector<int>{0});
  EXPECT_EQ(run.result.forces[0], gravity);
  // Speeds fall to the closure speed: some ln(1e6)/ln(1/r) impacts.
  EXPECT_LT(run.result.totals.impacts, 3.0 - std::log(1e6) / std::log(restitution));
  expect_reached("Z1", "all of the energy is lost, relative",
                 relative(run.result.totals.energy_lost, gravity * drop), 1e-12);
}

TEST(HardCases, Z1BouncingBall) {
  EXPECT_NEAR(std::sqrt(2.0 / 9.81) * 9.0, 4.0637127688715781, 1e-15);
  for (const double r : {0.1, 0.5, 0.8, 0.99}) expect_bouncing_ball(1.0, 9.81, r);
  expect_bouncing_ball(0.35, 1.62, 0.7);
  expect_bouncing_ball(2e-4, 9.81, 0.6);
}

// x'' + x = cos(W t), x <= s: stuck from t = 0, released at acos(s)/W.
System pushed_oscillator(double frequency, double stop, double restitution) {
  return support::forced_oscillator(1.0, 0.0, stop, restitution, frequency, 1.0);
}

struct ForcedChatter {
  double frequency, stop, restitution;
  double release, impact, speed, accumulation;
};

// The catalogue's two rows; two more from tests/reference (case Z2c) and its release time.
const ForcedChatter kForcedChatters[] = {
    {0.3, 0.1, 0.8, 4.9020963521111227, 16.723521925366774, 0.548917278001831, 24.562829155337235},
    {0.5, 0.2, 0.2, 2.7388768120091317, 9.428901675031412, 1.2929265446443167, 11.843334547756168}};

TEST(HardCases, Z2ForcedChatterSticksAndReleases) {
  for (const ForcedChatter& c : kForcedChatters) {
    SCOPED_TRACE(c.frequency);
    const System system = pushed_oscillator(c.frequency, c.stop, c.restitution);
    const RecordedRun run = record_run(system, state_of({c.stop}, {0.0}), for_periods(3));
    ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
    ASSERT_EQ(run.events.front().kind, EventKind::kRelease);
    expect_reached("Z2", "release, s", off(run.events.front().time, c.release), 1e-10);
    ASSERT_EQ(run.events[1].kind, EventKind::kImpact);
    expect_reached("Z2", "first impact, s", off(run.events[1].time, c.impact), 1e-10);
    expect_reached("Z2", "first impact, speed", relative(run.events[1].speed, c.speed), 1e-10);
    expect_reached("Z2", "accumulation, s", off(time_of(run, EventKind::kStick), c.accumulation),
                   1e-9);
    // Everything repeats after a period.
    const double period = 2.0 * std::numbers::pi / c.frequency;
    expect_reached("Z2", "second accumulation one period later, s",
                   off(time_of(run, EventKind::kStick, 2), c.accumulation + period), 1e-9);
    expect_reached("Z2", "second release one period later, s",
                   off(time_of(run, EventKind::kRelease, 2), c.release + period), 1e-10);
  }
}

TEST(HardCases, Z2StickingForgetsTheStart) {
  for (const ForcedChatter& c : kForcedChatters) {
    const System system = pushed_oscillator(c.frequency, c.stop, c.restitution);
    State reference;
    for (const double x : {0.0, 0.02, 0.05}) {
      for (const double v : {0.0, 0.1, -0.1}) {
        const RecordedRun run = record_run(system, state_of({x}, {v}), for_periods(4));
        ASSERT_GT(count(run, EventKind::kRelease), 0);
        const State& final = run.result.final;
        if (reference.q.size() == 0) reference = final;
        expect_reached(
            "Z2", "state is independent of a start that sticks",
            std::max(off(final.q[0], reference.q[0]), off(final.qdot[0], reference.qdot[0])),
            1e-14);
      }
    }
  }
}

// The orbit that sticks: its events are those of the catalogue, its multipliers are zero.
TEST(HardCases, Z2OrbitSticks) {
  const double turn = 2.0 * std::numbers::pi;
  const auto turned = [turn](double a, double b) { return std::abs(std::remainder(a - b, turn)); };
  for (const ForcedChatter& c : kForcedChatters) {
    SCOPED_TRACE(c.frequency);
    const System system = pushed_oscillator(c.frequency, c.stop, c.restitution);
    State reference;
    for (const double x : {c.stop, 0.0, 0.05}) {
      FinderOptions options;
      options.from_closed_form = options.from_random = false;
      const State start = state_of({x}, {0.0});
      const FoundOrbits found = find_orbits(system, start, options);
      ASSERT_EQ(found.orbits.size(), 1u) << found.notes.front();
      const Orbit& orbit = found.orbits.front();
      ASSERT_TRUE(orbit.sticks());
      ASSERT_EQ(orbit.sticking.size(), 1u);
      EXPECT_TRUE(orbit.admissible);
      EXPECT_EQ(orbit.stable, std::optional<bool>(true));
      const StickingPhase& sticking = orbit.sticking.front();
      expect_reached("Z2", "orbit that sticks: release, rad",
                     turned(sticking.to.phase, std::acos(c.stop)), 1e-10);
      expect_reached("Z2", "orbit that sticks: accumulation, s",
                     turned(sticking.from.phase, c.frequency * c.accumulation) / c.frequency, 1e-9);
      // The one that follows the release.
      const auto since = [&](const OrbitImpact& impact) {
        return wrapped(impact.phase - sticking.to.phase);
      };
      const auto first =
          std::min_element(orbit.impacts.begin(), orbit.impacts.end(),
                           [&](const auto& i, const auto& j) { return since(i) < since(j); });
      expect_reached("Z2", "orbit that sticks: first impact, s",
                     turned(first->phase, c.frequency * c.impact) / c.frequency, 1e-10);
      expect_reached("Z2", "orbit that sticks: first impact, speed",
                     relative(first->speed, c.speed), 1e-10);
      ASSERT_EQ(orbit.multipliers.size(), 2u);
      for (const Eigenvalue& multiplier : orbit.multipliers)
        expect_reached("Z2", "orbit that sticks: multipliers, all zero",
                       std::abs(multiplier.value) + multiplier.error, 0.0);
      // One period later, from any start that sticks.
      State& at = reference;
      const State after = record_run(system, start, for_periods(4)).result.final;
      if (at.q.size() == 0) at = after;
      expect_reached("Z2", "state is independent of a start that sticks",
                     std::max(off(after.q[0], at.q[0]), off(after.qdot[0], at.qdot[0])), 1e-14);
      expect_reached("Z2", "orbit that sticks: residual one period later", orbit.residual, 1e-14);
    }
  }
}

// How far a run that closes its chatter at v_c is from one that follows it a thousand times
// further, at the accumulation and in the state some time later.
struct ClosureError {
  double time = 0.0, state = 0.0;
};

ClosureError closure_error(const System& system, const State& start, double duration,
                           double closure_speed) {
  const auto run_with = [&](double speed) {
    SimulationOptions options = for_seconds(duration);
    options.closure_speed = speed;
    return record_run(system, start, options);
  };
  const RecordedRun coarse = run_with(closure_speed), fine = run_with(1e-9);
  return {off(time_of(coarse, EventKind::kStick), time_of(fine, EventKind::kStick)),
          (coarse.result.final.q - fine.result.final.q).norm() / fine.result.final.q.norm() +
              (coarse.result.final.qdot - fine.result.final.qdot).norm() /
                  fine.result.final.qdot.norm()};
}

// Slope of log(error) over log(v_c) between the ends of a ladder, where both ends are well above
// rounding. Between two speeds the last resolved impact jumps, so single steps scatter.
double observed_order(const std::function<double(double)>& error, double coarse, double fine) {
  // Mean over the speeds within one factor r of either end.
  const auto mean = [&](double speed) {
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) sum += std::log(error(speed * std::pow(0.8, k / 8.0)));
    return sum / 8.0;
  };
  return (mean(coarse) - mean(fine)) / std::log(coarse / fine);
}

TEST(HardCases, Z2ClosingCostsTheSquareOfItsSpeed) {
  const System one = pushed_oscillator(0.3, 0.1, 0.8);
  const double order_in_time = observed_order(
      [&](double v) { return closure_error(one, state_of({0.1}, {0.0}), 30.0, v).time; }, 3e-3,
      3e-5);
  expect_reached("Z2", "order of the accumulation time in v_c, less 2", off(order_in_time, 2.0),
                 0.1);
  // The state while stuck of three modes does better than O(v_c^2): what the closed stop does not
  // follow is the area under the tail's hops, each v^3/a_n^2.
  const Scene scene = support::reference_scene("sticking/rayl3");
  const System three = assemble(scene);
  const State start = initial_state(scene, three);
  const double stick = time_of(record_run(three, start, for_seconds(60.0)), EventKind::kStick);
  const double order_in_state = observed_order(
      [&](double v) { return closure_error(three, start, stick + 0.02, v).state; }, 1e-2, 3e-4);
  expect_reached("Z2", "order of the state while stuck in v_c, less 3", off(order_in_state, 3.0),
                 0.2);
}

// After a release the gap leaves with a triple zero; the free motion from there, in 50 digits.
TEST(HardCases, Z3ReleaseIsLeftOnceAndTheNextImpactIsMet) {
  using Real = boost::multiprecision::cpp_bin_float_50;
  for (const double frequency : {0.3, 0.37, 0.5, 0.8}) {
    for (const double stop : {0.05, 0.2, 0.6}) {
      SCOPED_TRACE(testing::Message() << "W " << frequency << ", s " << stop);
      const System system = pushed_oscillator(frequency, stop, 0.5);
      const Real w = frequency, s = stop, start = acos(s) / w;
      const Real amplitude = 1 / (1 - w * w);
      const Real c = s - amplitude * s, d = amplitude * w * sin(w * start);
      const auto gap = [&](const auto& t) {
        using T = std::decay_t<decltype(t)>;
        using std::cos, std::sin;
        const T since = t - static_cast<T>(start);
        return T(static_cast<T>(s) -
                 (static_cast<T>(c) * cos(since) + static_cast<T>(d) * sin(since) +
                  static_cast<T>(amplitude) * cos(static_cast<T>(w) * t)));
      };
      // The gap is positive at once; its next zero by marching far below its scales, then halving.
      double first = static_cast<double>(start) + 1.0 / 64, past = first;
      while (gap(past) > 0.0) {
        first = past;
        past += 1.0 / 4096;
      }
      Real low = first, high = past;
      ASSERT_GT(gap(low), 0);
      ASSERT_LE(gap(high), 0);
      for (int i = 0; i < 100; ++i) {
        const Real middle = (low + high) / 2;
        (gap(middle) > 0 ? low : high) = middle;
      }
      const double expected = static_cast<double>(high);
      const RecordedRun run =
          record_run(system, state_of({stop}, {0.0}), for_seconds(expected + 1e-6));
      ASSERT_EQ(run.events.size(), 2u);
      EXPECT_EQ(run.events[0].kind, EventKind::kRelease);
      EXPECT_EQ(run.events[1].kind, EventKind::kImpact);
      expect_reached("Z3", "release, s", off(run.events[0].time, static_cast<double>(start)),
                     1e-10);
      expect_reached("Z3", "next impact, s", off(run.events[1].time, expected), 1e-10);
    }
  }
}

// a = 0 without forcing: impacts every pi/w_d for ever, at speeds that fall by
// r e^{-delta pi/w_d}; no number of them is sticking.
void expect_false_zeno(double delta, double restitution) {
  SCOPED_TRACE(delta);
  const double half_turn = std::numbers::pi / std::sqrt(1.0 - delta * delta);
  const double factor = restitution * std::exp(-delta * half_turn);
  const RecordedRun run =
      record_run(oscillator(1.0, delta, 0.0, restitution), state_of({0.0}, {1.0}),
                 support::for_impacts(1001, 2000.0 * half_turn));
  ASSERT_EQ(run.events.size(), 1001u);
  EXPECT_EQ(run.result.outcome, RunOutcome::kEventBudget);
  EXPECT_TRUE(run.result.stuck.empty());
  EXPECT_EQ(run.events[0].time, 0.0);
  EXPECT_EQ(run.events[0].speed, 1.0);
  for (std::size_t k = 1; k <= 1000; ++k) {
    const double number = static_cast<double>(k);
    // After an impact the mass swings away and back: half a turn.
    expect_reached("Z4", "time of impact k <= 1000, relative",
                   relative(run.events[k].time, number * half_turn), 1e-13);
    const double speed = std::pow(factor, number);
    if (speed < 1e-290) break;
    expect_reached("Z4", "speed r^k, relative, over max(1, k/100)",
                   relative(run.events[k].speed, speed) / std::max(1.0, number / 100.0), 1e-13);
  }
}

TEST(HardCases, Z4FalseZeno) {
  expect_false_zeno(0.0, 0.8);
  expect_false_zeno(0.0, 0.5);
  expect_false_zeno(0.02, 0.9);
}

// r = 0: at the stop with speed, then at rest there. The force F cos(phase) against the spring's
// pull a decides.
TEST(HardCases, Z5WithoutRestitutionItSticksWherePushed) {
  for (const double stop : {-0.3, 0.0, 0.4}) {
    for (const double force : {-0.5, -0.1, 0.1, 0.5}) {
      SCOPED_TRACE(testing::Message() << "a " << stop << ", F " << force);
      const System system = support::forced_oscillator(1.0, 0.0, stop, 0.0, 0.2, force);
      const RecordedRun run = record_run(system, state_of({stop}, {0.7}), for_seconds(1e-2));
      ASSERT_GE(run.events.size(), 1u);
      EXPECT_EQ(run.events[0].kind, EventKind::kImpact);
      const bool pushed = force > stop;
      EXPECT_EQ(count(run, EventKind::kStick), pushed ? 1 : 0);
      EXPECT_EQ(run.events.size(), pushed ? 2u : 1u);
      EXPECT_EQ(run.result.stuck.size(), pushed ? 1u : 0u);
      if (!pushed) continue;
      EXPECT_EQ(run.events[1].time, 0.0);
      EXPECT_EQ(run.result.final.qdot[0], 0.0);
      expect_reached("Z5", "contact force after r = 0",
                     off(run.result.forces[0], force * std::cos(0.2e-2) - stop), 1e-15);
    }
  }
}

// x'' + x = F cos(W t), x <= s < 0, at rest on the stop: stuck for ever iff F <= |s|.
TEST(HardCases, Z6PreloadHoldsForEver) {
  const long long periods = support::kSlowBuild ? 10'000 : 1'000'000;
  for (const double force : {0.1, 0.2, 0.199999999}) {
    const System system = support::forced_oscillator(1.0, 0.0, -0.2, 0.7, 1.3, force);
    const RecordedRun run = record_run(system, state_of({-0.2}, {0.0}), for_periods(periods));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd);
    expect_reached("Z6", "events in 1e6 periods under a preload F <= |s|",
                   static_cast<double>(run.events.size()), 0.0);
    EXPECT_EQ(run.result.stuck, std::vector<int>{0});
    EXPECT_EQ(run.result.final.q[0], -0.2);
  }
}

TEST(HardCases, Z6PreloadLiftsOffAtItsForce) {
  for (const double frequency : {0.2, 1.3, 7.0}) {
    for (const double force : {0.2000001, 0.25, 3.0}) {
      const System system = support::forced_oscillator(1.0, 0.0, -0.2, 0.7, frequency, force);
      const RecordedRun run = record_run(system, state_of({-0.2}, {0.0}), for_periods(1));
      ASSERT_FALSE(run.events.empty());
      ASSERT_EQ(run.events[0].kind, EventKind::kRelease);
      // In long double: near F = |s| the arccosine multiplies the rounding of its argument.
      const double expected = static_cast<double>(
          std::acos(-static_cast<long double>(0.2) / static_cast<long double>(force)) / frequency);
      // The force touches zero there: its instant is known to three roundings of numbers of size 2F
      // (the force at the start, the change since, their sum), 3 eps F = 6.7e-16 F, over its slope
      // in time, W sqrt(F^2 - s^2).
      const double slope = frequency * std::sqrt((force - 0.2) * (force + 0.2));
      expect_reached("Z6", "lift-off where cos(W t) = s/F, s, over 1 + 6.7e-3 F/slope",
                     off(run.events[0].time, expected) / (1.0 + 6.7e-3 * force / slope), 1e-13);
    }
  }
}

// The unit cantilever held by a closed stop: the roots of sum phi_j^2/(w_j^2 - w^2) = 0.
Vector held_frequencies(int modes, double position) {
  System system{Vector(modes), NaturalModes{Vector::Zero(modes)}, {}};
  Vector row(modes);
  for (int j = 0; j < modes; ++j) {
    system.omega[j] = std::pow(cantilever_wave_number(j + 1), 2);
    row[j] = cantilever_shape(j + 1, position);
  }
  system.stops.push_back({row, 0.0, ImpactLaw{momentum_direction(row), 0.5}});
  return ConstrainedStructure<double>(system, {0}).reduced.omega;
}

TEST(HardCases, Z7FrequenciesOfTheHeldBeam) {
  for (const support::TableRow& row : support::read_table("constrained_frequencies.csv")) {
    if (row.at("N") == "inf") continue;
    const int modes = static_cast<int>(support::number(row, "N"));
    const Vector held = held_frequencies(modes, support::number(row, "position"));
    ASSERT_EQ(held.size(), modes - 1);
    const auto k = static_cast<Eigen::Index>(support::number(row, "k")) - 1;
    expect_reached("Z7", "frequencies of the stuck beam, relative",
                   relative(held[k], support::number(row, "frequency")), 1e-12);
  }
  // The clamped-pinned beam, tan b = tanh b, and how far N modes are from it.
  const double limit = 3.92660231204791878;
  expect_reached("Z7", "tan b = tanh b at the limit", off(std::tan(limit), std::tanh(limit)),
                 1e-14);
  const std::pair<int, double> truncations[] = {{5, 7.836e-4}, {10, 9.931e-5}, {20, 1.246e-5}};
  for (const auto& [modes, truncation] : truncations)
    expect_reached("Z7", "truncation at N = 5, 10, 20, relative to the printed one",
                   relative(std::sqrt(held_frequencies(modes, 1.0)[0]) / limit - 1.0, truncation),
                   1e-3);
}

}  // namespace
}  // namespace graze
