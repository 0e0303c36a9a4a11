// A stop that gives way, as its stiffness grows: its contacts shorten, and the motion tends to that
// at a rigid stop with the restitution of its contacts. Expected: closed forms, stated at each
// test.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "graze/assembly/detail/spring_law.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

// Duration of the Hertz contact of a free body, times v/x_max (hard case S1).
constexpr double kHertzDuration = 2.9432751843247;

ContactForce elastic(double k, double exponent) {
  ContactForce law;
  law.stiffness = k;
  law.exponent = exponent;
  return law;
}

// With restitution r of 1 kg, met alone, exactly.
ContactForce dashpot(double k, double r) {
  Spring spring;
  spring.stiffness = k;
  spring.exponent = 1.0;
  spring.damping.emplace();
  spring.damping->model = ContactModel::kKelvinVoigt;
  spring.damping->restitution = r;
  spring.damping->mass = 1.0;
  spring.damping->exact = true;
  return spring_law(spring);
}

// With restitution r at this speed.
ContactForce hunt_crossley(double k, double r, double speed) {
  Spring spring;
  spring.exponent = 1.5;
  spring.stiffness = k;
  spring.damping.emplace();
  spring.damping->model = ContactModel::kHuntCrossley;
  spring.damping->restitution = r;
  spring.damping->speed = speed;
  spring.damping->exact = true;
  return spring_law(spring);
}

System sprung(System system, const ContactForce& law) {
  system.stops.front().law = law;
  return system;
}

double duration(const ContactForce& law, double speed) {
  const auto run =
      support::record_run(sprung(support::oscillator(0.0, 0.0, 0.1, 0.0), law),
                          support::state_of({0.0}, {speed}), support::for_seconds(0.2 / speed));
  EXPECT_EQ(run.events.size(), 2u);
  EXPECT_EQ(run.events.back().kind, EventKind::kSeparation);
  return run.events.back().duration;
}

double slope(double from, double to, double decades) { return std::log10(to / from) / decades; }

// pi sqrt(m/k), and (m^2/(k^2 v))^(1/5) times a number: eight decades of k. Damping that gives the
// same restitution at every k changes the number only.
TEST(StiffeningStop, ContactsShortenAsTheyShould) {
  const double v = 0.5;
  double linear = 0.0, hertz = 0.0, damped = 0.0, damped_hertz = 0.0;
  for (int decade = 4; decade <= 12; decade += 2) {
    SCOPED_TRACE(decade);
    const double k = std::pow(10.0, decade);
    const double now = duration(elastic(k, 1.0), v), now_hertz = duration(elastic(k, 1.5), v);
    EXPECT_NEAR(now / (std::numbers::pi / std::sqrt(k)), 1.0, 1e-10);
    EXPECT_NEAR(now_hertz / (kHertzDuration * std::pow(1.25 * v * v / k, 0.4) / v), 1.0, 1e-10);
    const double now_damped = duration(dashpot(k, 0.6), v);
    const double now_both = duration(hunt_crossley(k, 0.6, v), v);
    if (decade > 4) {
      EXPECT_NEAR(slope(linear, now, 2), -0.5, 1e-10);
      EXPECT_NEAR(slope(hertz, now_hertz, 2), -0.4, 1e-10);
      EXPECT_NEAR(slope(damped, now_damped, 2), -0.5, 1e-10);
      EXPECT_NEAR(slope(damped_hertz, now_both, 2), -0.4, 1e-10);
    }
    linear = now, hertz = now_hertz, damped = now_damped, damped_hertz = now_both;
  }
}

State state_after(const System& system, const State& start, double seconds, std::size_t events) {
  const auto run = support::record_run(system, start, support::for_seconds(seconds));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_EQ(run.events.size(), events);
  return run.result.final;
}

// x'' + x = 0 before a stop at its place of rest, entered at speed 1: to first order in the
// duration T of a contact the oscillator then lags by T a contact behind the one at the rigid stop
// with r = 1, whose motion is -|sin|. The next order is T^2.
TEST(StiffeningStop, ElasticMotionLagsByTheContacts) {
  const double at = 10.6;  // three contacts at pi/2, 3 pi/2, 5 pi/2 lie before it
  const double rigid = -std::abs(std::sin(at - 0.5 * std::numbers::pi));
  for (const double exponent : {1.0, 1.5})
    for (const double k : {1e6, 1e8, 1e10, 1e12}) {
      SCOPED_TRACE(k);
      const double contact = exponent == 1.0 ? std::numbers::pi / std::sqrt(k)
                                             : kHertzDuration * std::pow(1.25 / k, 0.4);
      const System system = sprung(support::oscillator(1.0, 0.0, 0.0, 0.0), elastic(k, exponent));
      const State end = state_after(system, support::state_of({-1.0}, {0.0}), at, 6);
      // -sin(s) for s = at - pi/2 - 2 pi in (0, pi).
      const double speed = -std::cos(at - 2.5 * std::numbers::pi);
      EXPECT_NEAR((end.q[0] - rigid) / (-3.0 * contact * speed), 1.0, 5.0 * contact);
    }
}

// Falls with this power of k over six decades, and is small at the end of them. What comes next in
// the expansion is the square of the duration, at k = 1e6 some hundredths of it.
void expect_approach(const std::vector<double>& errors, double power, double last) {
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(slope(errors[i - 1], errors[i], 2), power, i == 1 ? 0.02 : 0.005) << i;
  EXPECT_LT(errors.back(), last);
}

double distance(const State& a, const State& b) {
  return std::hypot(a.q[0] - b.q[0], a.qdot[0] - b.qdot[0]);
}

// The forced oscillator of data/scenes/04_impact_oscillator.toml: every contact gives back r.
TEST(StiffeningStop, DampedMotionApproachesTheRigidOne) {
  const State start = support::state_of({-1.0}, {0.0});
  for (const double r : {1.0, 0.8}) {
    SCOPED_TRACE(r);
    const System rigid = support::forced_oscillator(1.0, 0.05, 0.0, r, 2.8, 1.0);
    const auto reference = support::record_run(rigid, start, support::for_seconds(7.0));
    const State end = reference.result.final;
    std::vector<double> errors;
    for (const double k : {1e6, 1e8, 1e10, 1e12})
      errors.push_back(distance(
          state_after(sprung(rigid, dashpot(k, r)), start, 7.0, 2 * reference.events.size()), end));
    expect_approach(errors, -0.5, 2e-5);
  }
}

// With r = 0.3 the rigid stop has a chatter and holds the oscillator for a while. The spring has a
// finite one: contacts slow down by r each until the push keeps the spring compressed, at a speed
// of the order k^(-1/2). Two decades of k make that ln 10/ln(1/r) = 1.9 contacts more.
TEST(StiffeningStop, AChatterBecomesLongerAndApproachesTheRigidOne) {
  const State start = support::state_of({-1.0}, {0.0});
  const System rigid = support::forced_oscillator(1.0, 0.05, 0.0, 0.3, 2.8, 1.0);
  const auto reference = support::record_run(rigid, start, support::for_seconds(7.0));
  ASSERT_GT(reference.result.totals.chatters, 0);
  std::vector<double> errors;
  std::size_t contacts = 0;
  for (const double k : {1e6, 1e8, 1e10, 1e12}) {
    const auto run =
        support::record_run(sprung(rigid, dashpot(k, 0.3)), start, support::for_seconds(7.0));
    EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
    const std::size_t now = run.events.size() / 2;
    if (contacts > 0) {
      EXPECT_NEAR(static_cast<double>(now - contacts), 1.9, 1.0) << k;
    }
    contacts = now;
    errors.push_back(distance(run.result.final, reference.result.final));
  }
  expect_approach(errors, -0.5, 2e-5);
}

// One contact at the speed 1 for which the damping is made.
TEST(StiffeningStop, HuntAndCrossleysMotionApproachesTheRigidOne) {
  const State start = support::state_of({-1.0}, {0.0});
  for (const double r : {0.8, 0.3}) {
    SCOPED_TRACE(r);
    const System rigid = support::oscillator(1.0, 0.0, 0.0, r);
    const State end = state_after(rigid, start, 3.0, 1);
    std::vector<double> errors;
    for (const double k : {1e6, 1e8, 1e10, 1e12})
      errors.push_back(
          distance(state_after(sprung(rigid, hunt_crossley(k, r, 1.0)), start, 3.0, 2), end));
    expect_approach(errors, -0.4, 2e-4);
  }
}

}  // namespace
}  // namespace graze
