// Dry friction against closed forms, and against an integration of its own in long double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/simulation.hpp"
#include "support/friction_reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

Friction friction(const Vector& row, double sliding, double sticking, double speed = 0.0) {
  return {row, momentum_direction(row), sliding, sticking, speed};
}

System sliding_oscillator(double omega, double sliding, double sticking, double speed = 0.0) {
  System system{Vector::Constant(1, omega), NaturalModes{Vector::Zero(1)}, {}};
  system.frictions.push_back(friction(Vector::Ones(1), sliding, sticking, speed));
  return system;
}

SimulationOptions with_energy(double duration) {
  SimulationOptions options = support::for_seconds(duration);
  options.energy = true;
  return options;
}

// x'' + w^2 x = -+F: the amplitude falls by 2 F/w^2 each half period pi/w, until w^2 |x| <= F.
TEST(Friction, TakesTheSameFromEachSwing) {
  for (const double force : {0.3, 0.07, 0.9}) {
    const double w = 2.0;
    const auto run = support::record_run(sliding_oscillator(w, force, force),
                                         support::state_of({1.0}, {0.0}), with_energy(120.0));
    double amplitude = 1.0;
    std::size_t swings = 0;
    while (w * w * amplitude > force) {
      amplitude = std::abs(amplitude - 2.0 * force / (w * w));
      ++swings;
    }
    ASSERT_EQ(run.events.size(), swings) << force;
    for (std::size_t k = 0; k < swings; ++k) {
      EXPECT_NEAR(run.events[k].time, std::numbers::pi / w * static_cast<double>(k + 1), 1e-12);
      EXPECT_EQ(run.events[k].kind,
                k + 1 < swings ? EventKind::kReversal : EventKind::kFrictionStick);
    }
    EXPECT_NEAR(std::abs(run.result.final.q[0]), amplitude, 1e-12);
    EXPECT_EQ(run.result.final.qdot[0], 0.0);
    EXPECT_LE(std::abs(run.result.energy->defect()), 1e-12);
  }
}

// A mass on a belt at speed V, held by a spring: it sticks up to the static force S, and slides
// against F. In sliding it swings about F/k with V in velocity; the period is that of the slip,
// (pi + 2 atan((S - F)/(m w V))) 2... and of the way that the belt then carries it.
TEST(Friction, StickSlipOnABeltHasItsPeriod) {
  for (const auto& [s, f, v, w] : {std::array{1.0, 0.5, 0.2, 1.0}, std::array{3.0, 2.2, 0.7, 2.5},
                                   std::array{0.4, 0.1, 1.3, 0.6}}) {
    const auto run = support::record_run(sliding_oscillator(w, f, s, v),
                                         support::state_of({0.0}, {v}), with_energy(400.0 / w));
    std::vector<double> slips;
    for (const Event& event : run.events)
      if (event.kind == EventKind::kSlip) slips.push_back(event.time);
    ASSERT_GE(slips.size(), 6u);
    const double slip = 2.0 / w * (std::numbers::pi - std::atan((s - f) / (w * v)));
    const double stick = 2.0 * (s - f) / (w * w * v);
    for (std::size_t k = 2; k < slips.size(); ++k)
      EXPECT_NEAR(slips[k] - slips[k - 1], slip + stick, 1e-10 * (slip + stick)) << w << " " << k;
    EXPECT_LE(std::abs(run.result.energy->defect()), 1e-12 * run.result.energy->size());
  }
}

// Friction between two masses that move freely: they have one speed once the faster has slowed
// down.
TEST(Friction, BetweenTwoMassesIsInternal) {
  System system{Vector::Zero(2), NaturalModes{Vector::Zero(2)}, {}};
  const double m1 = 2.0, m2 = 0.5, force = 0.3, v = 1.7;
  Vector row(2);
  row << 1.0 / std::sqrt(m1), -1.0 / std::sqrt(m2);
  system.frictions.push_back(friction(row, force, force));
  const auto run = support::record_run(
      system, support::state_of({0.0, 0.0}, {v * std::sqrt(m1), 0.0}), with_energy(10.0));
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_EQ(run.events[0].kind, EventKind::kFrictionStick);
  EXPECT_NEAR(run.events[0].time, v / (force / m1 + force / m2), 1e-14);
  const double common = m1 * v / (m1 + m2);
  EXPECT_NEAR(run.result.final.qdot[0] / std::sqrt(m1), common, 1e-15);
  EXPECT_NEAR(run.result.final.qdot[1] / std::sqrt(m2), common, 1e-15);
}

// Code_Aster's SDND106: masses of 5 and a spring of 1e4; the first sticks up to 3000 and slides
// against 2000; 3000 N on the second until .2 s.
TEST(Friction, SlipsAndSticksAsInSdnd106) {
  const double m = 5.0, k = 1e4, limit = 3000.0, sliding = 2000.0, load = 3000.0;
  const double w = std::sqrt(2.0 * k / m);  // of both masses together, beside their free motion
  System system{Vector(2), NaturalModes{Vector::Zero(2)}, {}};
  system.omega << 0.0, w;
  // Modes (1, 1) and (1, -1), each mass 5.
  const double part = 1.0 / std::sqrt(2.0 * m);
  Vector first(2), second(2);
  first << part, part;
  second << part, -part;
  system.modal().load = load * second;
  system.frictions.push_back(friction(first, sliding, limit));
  auto run = support::record_run(system, support::rest(system), with_energy(0.2));
  ASSERT_EQ(run.events.size(), 1u);
  const double w2 = std::sqrt(k / m), slips = std::acos(1.0 - limit / load) / w2;
  EXPECT_NEAR(run.events[0].time, slips, 1e-12);
  EXPECT_NEAR(slips, 0.03512, 5e-6);
  // From there the centre is accelerated by (load - sliding)/(2 m), and the distance d swings about
  // its rest, m d'' = -2 k d + load + sliding.
  const double d0 = load / k * (1.0 - std::cos(w2 * slips)),
               v0 = load / k * w2 * std::sin(w2 * slips);
  const double push = (load - sliding) / (2.0 * m), rest = (load + sliding) / (2.0 * k);
  const auto centre = [&](double t) { return 0.5 * d0 + 0.5 * v0 * t + 0.5 * push * t * t; };
  const auto distance = [&](double t) {
    return rest + (d0 - rest) * std::cos(w * t) + v0 / w * std::sin(w * t);
  };
  const double t = 0.2 - slips;
  EXPECT_NEAR(first.dot(run.result.final.q), centre(t) - 0.5 * distance(t), 1e-10);
  EXPECT_NEAR(second.dot(run.result.final.q), centre(t) + 0.5 * distance(t), 1e-10);
  // Printed of a motion in steps.
  EXPECT_NEAR(centre(0.15 - slips) - 0.5 * distance(0.15 - slips), 1.35332, 3e-5);
  EXPECT_NEAR(centre(0.15 - slips) + 0.5 * distance(0.15 - slips), 1.80751, 3e-5);
  // Without the load the first comes to rest, and sticks where the second swings about it.
  system.modal().load.reset();
  run = support::record_run(system, run.result.final, with_energy(0.2));
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_EQ(run.events[0].kind, EventKind::kFrictionStick);
  EXPECT_NEAR(run.events[0].time + 0.2, 0.31492, 5e-6);
  EXPECT_LE(std::abs(run.result.energy->defect()), 1e-12 * run.result.energy->size());
}

// A mass on a plane that is shaken along it by a(t) = mu g s sin(2 pi t), s as in SDND100 and 104:
// below 1 it sticks for ever; above it slips when s sin = 1, and its velocity relative to the plane
// is the integral of what exceeds the friction.
TEST(Friction, SlidesOnAShakenPlane) {
  for (const double s : {15.0, 1.5, 1.01, 0.99}) {
    const double mu = 0.1 * 9.81, turn = 2.0 * std::numbers::pi;
    System system{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {}};
    system = support::forced(system, turn, -0.5 * std::numbers::pi, Vector::Constant(1, mu * s));
    system.frictions.push_back(friction(Vector::Ones(1), mu, mu));
    const auto run = support::record_run(system, support::rest(system), with_energy(0.45));
    if (s < 1.0) {
      EXPECT_TRUE(run.events.empty());
      EXPECT_EQ(run.result.final.q[0], 0.0);
      continue;
    }
    const double slips = std::asin(1.0 / s) / turn;
    ASSERT_GE(run.events.size(), 1u);
    EXPECT_EQ(run.events[0].kind, EventKind::kSlip);
    EXPECT_NEAR(run.events[0].time, slips, 1e-10);
    const auto velocity = [&](double t) {
      return mu * (s / turn * (std::cos(turn * slips) - std::cos(turn * t)) - (t - slips));
    };
    double low = 0.5 - slips, high = 3.0;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (velocity(middle) > 0.0 ? low : high) = middle;
    }
    if (run.events.size() > 1)
      EXPECT_NEAR(run.events[1].time, low, 1e-10);
    else
      EXPECT_NEAR(run.result.final.qdot[0], velocity(0.45), 1e-12);
  }
}

System random_system(support::Dice& dice) {
  const int modes = 1 + dice.pick(3);
  System system{dice.vector(modes, 0.4, 4.0), NaturalModes{Vector::Zero(modes)}, {}};
  // Undamped, a mass on a belt comes back to its speed as a tangent, within rounding.
  const bool belts = dice.pick(3) == 0;
  if (belts || dice.pick(2)) system.modal().delta = dice.uniform(0.01, 0.2) * system.omega;
  if (dice.pick(4)) {
    system.modal().forcing = HarmonicForcing{dice.uniform(0.3, 3.0), dice.uniform(0.0, 6.0),
                                             dice.vector(modes, -1.5, 1.5)};
  }
  if (dice.pick(3) == 0) system.modal().load = dice.vector(modes, -0.5, 0.5);
  const int frictions = 1 + dice.pick(modes);
  for (int k = 0; k < frictions; ++k) {
    const double sliding = dice.uniform(0.05, 0.8);
    system.frictions.push_back(
        friction(dice.vector(modes, -1.0, 1.0), sliding,
                 // Of several the one that slips first decides for the others, whichever that is.
                 dice.pick(2) || frictions > 1 ? sliding : sliding * dice.uniform(1.0, 1.6),
                 belts ? dice.uniform(-0.4, 0.4) : 0.0));
  }
  for (int k = dice.pick(3); k > 0; --k) {
    const Vector row = dice.vector(modes, -1.0, 1.0);
    const double gap = dice.uniform(0.3, 1.2);
    system.stops.push_back({row, gap, ImpactLaw{momentum_direction(row), dice.uniform(0.3, 1.0)}});
    if (dice.pick(3) == 0)
      system.stops.back().law =
          ContactForce{dice.uniform(2.0, 20.0), 1.0, ContactDamping::kNone, 0.0};
    // Friction at it, along another row.
    if (!system.stops.back().is_compliant() || modes < 2 || frictions == modes || dice.pick(2))
      continue;
    const double part = dice.uniform(0.1, 0.8);
    system.frictions.push_back(
        friction(dice.vector(modes, -1.0, 1.0), part, part, belts ? dice.uniform(-0.4, 0.4) : 0.0));
    system.frictions.back().stop = static_cast<int>(system.stops.size()) - 1;
    break;
  }
  return system;
}

// Events before a time; those of one instant in the order of their places.
std::vector<support::FrictionReference::Happened> in_order(
    std::vector<support::FrictionReference::Happened> events, double last) {
  std::erase_if(events, [&](const auto& event) { return !(event.time < last); });
  for (auto from = events.begin(); from != events.end();) {
    const auto to = std::find_if(from, events.end(),
                                 [&](const auto& event) { return event.time - from->time > 1e-9; });
    std::stable_sort(from, to, [](const auto& a, const auto& b) {
      return std::pair(a.kind != EventKind::kImpact, a.index) <
             std::pair(b.kind != EventKind::kImpact, b.index);
    });
    from = to;
  }
  return events;
}

// The first event that is not alike; empty where there is none.
std::string difference(const System& system, const State& start, double end) {
  support::FrictionReference reference(system, start);
  const auto& wanted = reference.run(static_cast<long double>(end));
  const auto run = support::record_run(system, start, with_energy(reference.time()));
  if (run.result.outcome != RunOutcome::kReachedEnd) return run.result.message;
  if (!(std::abs(run.result.energy->defect()) <= 1e-10 * (1.0 + run.result.energy->size())))
    return "energy " + std::to_string(run.result.energy->defect());
  const double last = reference.crowded() ? reference.time() - 1e-3 : reference.time() - 1e-9;
  using Happened = support::FrictionReference::Happened;
  std::vector<Happened> got;
  for (const Event& event : run.events)
    got.push_back({event.time, event.kind, event.stop < 0 ? event.friction : event.stop});
  const std::vector<Happened> want = in_order(wanted, last), have = in_order(got, last);
  for (std::size_t i = 0; i < std::min(want.size(), have.size()); ++i)
    if (have[i].kind != want[i].kind || have[i].index != want[i].index ||
        std::abs(have[i].time - want[i].time) > 1e-10)
      return fmt::format("{} of {} at {:.12f}, not {} of {} at {:.12f}",
                         static_cast<int>(have[i].kind), have[i].index, have[i].time,
                         static_cast<int>(want[i].kind), want[i].index, want[i].time);
  if (want.size() != have.size()) return fmt::format("{} events, not {}", have.size(), want.size());
  if (!reference.crowded() && (run.result.final.q - reference.q().cast<double>()).norm() > 1e-10)
    return "another end";
  return "";
}

// Two modes that a spring with friction couples flutter, as brakes squeal: k (b + mu t) b^T is not
// symmetric, and its eigenvalues meet and leave the axis. The sliding goes on while a belt is fast.
TEST(Friction, AtASpringMakesModesFlutter) {
  System system{Vector{{1.3, 1.0}}, NaturalModes{Vector::Zero(2)}, {}};
  const Vector row{{0.6, 0.8}}, along{{1.0, 0.0}};
  const double mu = 0.9;
  system.modal().load = Vector{{0.0, -0.5}};
  system.stops.push_back({row, -1.0, ContactForce{1.0, 1.0, ContactDamping::kNone, 0.0}});
  system.frictions.push_back(friction(along, mu, mu, 5.0));
  system.frictions.back().stop = 0;
  Matrix stiffness = system.omega.cwiseAbs2().asDiagonal();
  stiffness += (row - mu * along) * row.transpose();
  const double half = 0.5 * stiffness.trace();
  EXPECT_LT(half * half - stiffness.determinant(), 0.0);
  EXPECT_EQ(difference(system, {Vector{{0.2, 0.1}}, Vector::Zero(2)}, 60.0), "");
}

TEST(Friction, MovesAsIntegratedInLongDouble) {
  const char* asked = std::getenv("GRAZE_CASES");
  const int cases = asked ? std::atoi(asked) : 60;
  const char* first = std::getenv("GRAZE_FIRST_CASE");
  for (int i = first ? std::atoi(first) : 0; i < cases; ++i) {
    support::Dice dice(static_cast<std::uint64_t>(i) + 7000);
    const System system = random_system(dice);
    const State start{Vector::Zero(system.modes()), dice.vector(system.modes(), -1.0, 1.0)};
    const std::string found = difference(system, start, 30.0);
    EXPECT_EQ(found, "") << "case " << i;
  }
}

}  // namespace
}  // namespace graze
