// Compliant stops: contacts entered and left, against closed forms and published numbers.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/contact/detail/restitution_damping.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

ContactForce linear(double k, double c = 0.0, Separation separation = Separation::kAtZeroForce) {
  return {k,   1.0,       c > 0.0 ? ContactDamping::kConstant : ContactDamping::kNone, c, 0.0,
          0.0, separation};
}

System sprung(double omega, double gap, const ContactForce& law) {
  System system = support::oscillator(omega, 0.0, gap, 0.0);
  system.stops.front().law = law;
  return system;
}

std::vector<Event> of_kind(const std::vector<Event>& events, EventKind kind) {
  std::vector<Event> found;
  for (const Event& event : events)
    if (event.kind == kind) found.push_back(event);
  return found;
}

// Half periods of two frequencies take turns: pi/w out, pi/sqrt(w^2 + k) in.
TEST(CompliantStop, PiecewiseLinearOscillator) {
  const double w = 2.0, k = 5000.0, stiff = std::sqrt(w * w + k);
  const System system = sprung(w, 0.0, linear(k));
  const double cycle = std::numbers::pi / w + std::numbers::pi / stiff;
  const auto run = support::record_run(system, support::state_of({-1.0}, {0.0}),
                                       support::for_seconds(10.2 * cycle));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  const auto contacts = of_kind(run.events, EventKind::kContact);
  const auto separations = of_kind(run.events, EventKind::kSeparation);
  ASSERT_EQ(contacts.size(), 10u);
  ASSERT_EQ(separations.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    const double entry = 0.5 * std::numbers::pi / w + static_cast<double>(i) * cycle;
    EXPECT_NEAR(contacts[i].time, entry, 1e-12);
    EXPECT_NEAR(contacts[i].speed, w, 1e-11);
    EXPECT_NEAR(separations[i].time, entry + std::numbers::pi / stiff, 1e-12);
    EXPECT_NEAR(separations[i].duration, std::numbers::pi / stiff, 1e-12);
    EXPECT_NEAR(separations[i].peak_force, k * w / stiff, 1e-9);
    ASSERT_TRUE(separations[i].effective_restitution);
    EXPECT_NEAR(*separations[i].effective_restitution, 1.0, 1e-11);
  }
}

// At rest exactly on the surface: what follows is told by the first derivative that is not zero.
TEST(CompliantStop, AtRestOnTheSurface) {
  // Nothing moves it.
  System system = sprung(2.0, 0.0, linear(1000.0));
  auto run =
      support::record_run(system, support::state_of({0.0}, {0.0}), support::for_seconds(5.0));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_TRUE(run.events.empty());
  EXPECT_EQ(run.result.final.q[0], 0.0);
  // A force sin(t), -sin(t): the push is zero, its rate presses or pulls. A free mass on a spring
  // then moves as x'' + k x = sin(t): x = (sin(t) - sin(w t)/w)/(k - 1).
  for (const double sense : {1.0, -1.0}) {
    system = sprung(0.0, 0.0, linear(100.0));
    system.modal().forcing =
        HarmonicForcing{1.0, -std::numbers::pi / 2.0, Vector::Constant(1, sense)};
    run = support::record_run(system, support::state_of({0.0}, {0.0}), support::for_seconds(0.2));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    const double expected =
        sense > 0.0 ? (std::sin(0.2) - std::sin(2.0) / 10.0) / 99.0 : -(0.2 - std::sin(0.2));
    EXPECT_NEAR(run.result.final.q[0], expected, 1e-12) << sense;
  }
}

// Hard case S2, at the stop of a free mass.
TEST(CompliantStop, SpringDashpotByBothRules) {
  for (const double zeta : {0.05, 0.3, 0.8})
    for (const Separation rule : {Separation::kAtZeroForce, Separation::kAtZeroDepth}) {
      const double k = 1e5;
      const System system = sprung(0.0, 0.25, linear(k, 2.0 * zeta * std::sqrt(k), rule));
      const auto run =
          support::record_run(system, support::state_of({0.0}, {0.5}), support::for_seconds(1.0));
      EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
      const auto contacts = of_kind(run.events, EventKind::kContact);
      const auto separations = of_kind(run.events, EventKind::kSeparation);
      ASSERT_EQ(contacts.size(), 1u);
      ASSERT_EQ(separations.size(), 1u);
      EXPECT_NEAR(contacts[0].time, 0.5, 1e-13);
      const double e = rule == Separation::kAtZeroForce ? restitution_at_zero_force(zeta)
                                                        : restitution_at_zero_depth(zeta);
      EXPECT_NEAR(*separations[0].effective_restitution, e, 1e-10) << zeta;
      // Nothing acts after the separation, whatever the depth.
      EXPECT_NEAR(run.result.final.qdot[0], -0.5 * e, 1e-10);
    }
}

// Hard case S5, Timoshenko's sphere of 10 mm that meets the middle of a steel beam at 10 mm/s: a
// free mode and the 25 first symmetric ones.
TEST(CompliantStop, S5SphereOnABeam) {
  const double length = 0.1535, side = 0.01, rho = 7850.0, modulus = 206e9;
  const double line = rho * side * side, stiffness = modulus * std::pow(side, 4) / 12.0;
  const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-6 * rho, v = 0.01;
  const int modes = 25;
  System system{Vector::Zero(modes + 1), NaturalModes{Vector::Zero(modes + 1)}, {}};
  Vector row(modes + 1);
  row[0] = 1.0 / std::sqrt(mass);
  for (int j = 1; j <= modes; ++j) {
    const double n = 2.0 * j - 1.0, wave = n * std::numbers::pi / length;
    system.omega[j] = wave * wave * std::sqrt(stiffness / line);
    row[j] = -std::sqrt(2.0 / (line * length)) * std::sin(0.5 * n * std::numbers::pi);
  }
  system.stops.push_back({row, 0.0, ContactForce{1.5091575091575e10, 1.5}});
  State start{Vector::Zero(modes + 1), Vector::Zero(modes + 1)};
  start.qdot[0] = std::sqrt(mass) * v;
  const auto run = support::record_run(system, start, support::for_seconds(3e-4));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  const auto separations = of_kind(run.events, EventKind::kSeparation);
  ASSERT_GE(separations.size(), 1u);
  EXPECT_NEAR(separations[0].time, 158.519e-6, 5e-10);
  EXPECT_NEAR(separations[0].peak_force, 4.842663, 5e-7);
  const double energy = 0.5 * mass * v * v;
  EXPECT_NEAR(0.5 *
                  (run.result.final.qdot.squaredNorm() +
                   system.omega.cwiseProduct(run.result.final.q).squaredNorm()) /
                  energy,
              1.0, 1e-10);
}

// A beam that stays on a damped spring while its other modes move on: what they move by is known to
// their own rounding only, not to that of the slow contact.
TEST(CompliantStop, LongContactsOfABeam) {
  for (const char* ratio : {"0.3", "5.0"}) {
    const Scene scene = parse_scene(
        std::string("[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\n"
                    "density = 8500.0\narea = 12.4e-6\nmodes = 4\n[damping]\nviscous = 0.005\n"
                    "[forcing]\nkind = \"base\"\namplitude = 0.0006\nfrequency = 28.3\n"
                    "[[stop]]\nposition = 0.3\ngap = 1.05e-3\nside = \"below\"\n"
                    "[stop.spring]\nstiffness = 1e7\nexponent = 1\n"
                    "damping = { model = \"kelvin-voigt\", mass = 0.002, ratio = ") +
            ratio + " }\n",
        "scene.toml");
    const System system = assemble(scene);
    const auto run =
        support::record_run(system, initial_state(scene, system), support::for_seconds(2.0));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    // Each contact is left before the next is entered.
    bool inside = false;
    for (const Event& event : run.events) {
      EXPECT_EQ(event.kind, inside ? EventKind::kSeparation : EventKind::kContact);
      inside = !inside;
    }
    EXPECT_GT(run.events.size(), 10u);
  }
}

// A ball that comes to rest on a damped floor presses it in by m g/k.
TEST(CompliantStop, ComesToRestCompressed) {
  const double k = 2000.0, g = 9.81;
  System system = sprung(0.0, 0.1, linear(k, 40.0));
  system.modal().load = Vector::Constant(1, g);
  const auto run =
      support::record_run(system, support::state_of({0.0}, {0.0}), support::for_seconds(10.0));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_NEAR(run.result.final.q[0], 0.1 + g / k, 1e-10);
  EXPECT_NEAR(run.result.final.qdot[0], 0.0, 1e-10);
  const auto contacts = of_kind(run.events, EventKind::kContact);
  ASSERT_GE(contacts.size(), 2u);
  EXPECT_NEAR(contacts[0].time, std::sqrt(0.2 / g), 1e-12);
}

// F = x^(3/2) (k + C v) on a free body decays towards the speed -k/C without ever being zero: what
// tells gripping from not is rounding, and the contact ends at the surface. With z = C v/k the work
// of the force gives z - ln(1 + z) at the end as at the start.
TEST(CompliantStop, AForceThatFadesToRoundingDoesNotComeAndGo) {
  for (const double e : {0.02, 0.05, 0.1}) {
    SCOPED_TRACE(e);
    const double k = 1e9, c = 8.0 * k * (1.0 - e) / (5.0 * e);  // Flores et al. (2011), at 1 m/s
    System system = support::oscillator(0.0, 0.0, 1e-3, 1.0);
    ContactForce law;
    law.stiffness = k;
    law.exponent = 1.5;
    law.damping = ContactDamping::kPower;
    law.coefficient = c;
    system.stops[0].law = law;
    const support::RecordedRun run =
        support::record_run(system, support::state_of({0.0}, {1.0}), support::for_seconds(0.5));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    EXPECT_LE(run.events.size(), 6u);
    const double start = c / k, kept = start - std::log1p(start);
    double z = -1.0;
    for (int turn = 0; turn < 50; ++turn) z = std::exp(z - kept) - 1.0;
    // Steps err by 1e-13 of the contact's speed, 1 m/s.
    EXPECT_NEAR(run.result.final.qdot[0], z * k / c, 1e-12);
  }
}

// A body pressed on a spring whose damping grows with the depth parts and grips again for ever
// shorter: every return is one of the motion, not of rounding.
TEST(CompliantStop, GripsAgainOnlyWhenTheForceDoes) {
  for (const double push : {1.0, 5.0, 20.0, 60.0}) {
    SCOPED_TRACE(push);
    System system = support::oscillator(0.0, 0.0, 0.01, 1.0);
    system.modal().load = Vector::Constant(1, push);
    ContactForce law;
    law.stiffness = 6.3e7;
    law.exponent = 1.5;
    law.damping = ContactDamping::kDepth;
    law.coefficient = 3.8e6;
    system.stops[0].law = law;
    const support::RecordedRun run =
        support::record_run(system, support::state_of({0.0}, {0.0}), support::for_seconds(2.0));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    for (std::size_t i = 1; i < run.events.size(); ++i)
      EXPECT_GT(run.events[i].time, run.events[i - 1].time) << i;
  }
}

// A Hunt-Crossley spring lets a body that is pressed into it out no faster than k/C, where its
// force is zero; from deep within that takes 1e11 times as long as the force needs to settle, in
// one flight without an event. It ends when it is told to, where it began.
TEST(CompliantStop, AFlightOfAnyLengthCanBeStopped) {
  System system = sprung(
      2.0, 0.0, {1e14, 1.5, ContactDamping::kPower, 1e15, 0.0, 0.0, Separation::kAtZeroForce});
  system.modal().load = Vector{{5.0}};
  const State deep = support::state_of({1e-2}, {0.0});
  SimulationOptions options = support::for_seconds(1.0);
  options.stop.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(10);
  const Simulation run = simulate(system, deep, options, {});
  EXPECT_EQ(run.outcome, RunOutcome::kTimeBudget) << run.message;
  EXPECT_LT(run.end_time, 1e-6);
  EXPECT_NEAR(run.final.q[0], deep.q[0], 1e-6);
}

// Every touch of a spring with a damper is a contact or a separation, none a grazing that was
// passed.
TEST(CompliantStop, ContactsOfADampedSpringAreNoUndecidedTouches) {
  for (const char* name : {"12_spring_dashpot_oscillator", "13_beam_on_a_spring",
                           "14_beam_against_a_ball", "17_yigit_lee_wang_1"}) {
    const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/" + std::string(name) + ".toml");
    const System system = assemble(scene);
    const auto run =
        support::record_run(system, initial_state(scene, system), support::for_seconds(2.0));
    EXPECT_GT(run.result.totals.impacts, 0) << name;
    EXPECT_EQ(run.result.totals.undecided_touches, 0) << name;
  }
}

}  // namespace
}  // namespace graze
