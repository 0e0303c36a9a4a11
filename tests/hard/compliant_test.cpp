// S: stops that give way. Expected values: closed forms and published numbers, stated at each test.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/assembly/initial_state.hpp"
#include "support/reached.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::expect_reached;
using support::relative;

struct Encounter {
  Event separation;
  State after;
};

// The first contact of a free body.
Encounter encounter(const ContactForce& law, double mass, double speed, double gap) {
  const Vector row = Vector::Constant(1, 1.0 / std::sqrt(mass));
  System system{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {}};
  system.stops.push_back({row, gap, law});
  const double n = law.exponent + 1.0;
  const double deepest = std::pow(0.5 * n * mass * speed * speed / law.stiffness, 1.0 / n);
  const auto run = support::record_run(system, support::state_of({0.0}, {std::sqrt(mass) * speed}),
                                       support::for_seconds((gap + 100.0 * deepest) / speed));
  EXPECT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  EXPECT_EQ(run.events.size(), 2u);
  return {run.events.back(), run.result.final};
}

ContactForce spring(double k, double exponent) {
  ContactForce law;
  law.stiffness = k;
  law.exponent = exponent;
  return law;
}

// x_max = (5 m v^2/(4 k))^(2/5), duration 2.9432751843247 x_max/v (Johnson, Contact Mechanics,
// section 11.4), at the stop and 1 mm, a hundred times the depth and more, away from it.
TEST(HardCases, S1HertzElastic) {
  struct Case {
    double k, m, v, deepest, duration;
  };
  for (const Case& c : {Case{3e9, 0.1, 0.1, 1.11664597110381e-5, 3.286596376426e-4},
                        Case{3e9, 1.0, 1e-6, 2.8048878636155e-9, 8.25555684379303e-3}}) {
    EXPECT_NEAR(std::pow(1.25 * c.m * c.v * c.v / c.k, 0.4) / c.deepest, 1.0, 1e-13);
    for (const double gap : {0.0, 1e-3}) {
      const Encounter found = encounter(spring(c.k, 1.5), c.m, c.v, gap);
      expect_reached("S1", "Hertz contact: duration, relative",
                     relative(found.separation.duration, c.duration), 1e-10);
      expect_reached("S1", "Hertz contact: largest force, relative",
                     relative(found.separation.peak_force, c.k * std::pow(c.deepest, 1.5)), 1e-11);
      expect_reached("S1", "Hertz contact: speed away, relative",
                     relative(found.separation.speed, c.v), 1e-12);
    }
  }
  EXPECT_NEAR(3e9 * std::pow(1.11664597110381e-5, 1.5), 111.942373173511, 1e-9);
}

// e = exp(-pi zeta/sqrt(1 - zeta^2)) where the contact ends at zero depth, and
// exp(-2 zeta arccos(zeta)/sqrt(1 - zeta^2)) at zero force.
TEST(HardCases, S2SpringDashpot) {
  const double k = 1e6, m = 0.3;
  const auto restitution = [&](double zeta, Separation release) {
    ContactForce law = spring(k, 1.0);
    law.damping = ContactDamping::kConstant;
    law.coefficient = 2.0 * zeta * std::sqrt(k * m);
    law.separation = release;
    return encounter(law, m, 0.2, 1e-3).separation.effective_restitution.value();
  };
  for (const double zeta : {0.01, 0.05, 0.3, 0.8}) {
    const double turn = std::sqrt(1.0 - zeta * zeta);
    expect_reached("S2", "spring-dashpot that parts at zero depth: e",
                   support::off(restitution(zeta, Separation::kAtZeroDepth),
                                std::exp(-std::numbers::pi * zeta / turn)),
                   1e-10);
    expect_reached("S2", "spring-dashpot that parts at zero force: e",
                   support::off(restitution(zeta, Separation::kAtZeroForce),
                                std::exp(-2.0 * zeta * std::acos(zeta) / turn)),
                   1e-10);
  }
  expect_reached("S2", "zeta = 0.3, at zero depth: e",
                 support::off(restitution(0.3, Separation::kAtZeroDepth), 0.372326104926586),
                 1e-11);
  expect_reached("S2", "zeta = 0.3, at zero force: e",
                 support::off(restitution(0.3, Separation::kAtZeroForce), 0.450975452893128),
                 1e-11);
}

// A (1 + e) = ln[(1 + A)/(1 - A e)] for F = k x^n (1 + d v), A = d v: solved with 40 digits.
TEST(HardCases, S3HuntCrossley) {
  const double k = 2e8, m = 0.5, v = 0.3;
  const auto restitution = [&](double a, double exponent) {
    ContactForce law = spring(k, exponent);
    law.damping = ContactDamping::kPower;
    law.coefficient = a * k / v;
    return encounter(law, m, v, 1e-3).separation.effective_restitution.value();
  };
  for (const double exponent : {1.0, 1.5, 2.2}) {
    const auto expect = [&](double a, double e) {
      expect_reached("S3", "F = k x^n (1 + d v), n = 1, 1.5, 2.2: e",
                     support::off(restitution(a, exponent), e), 1e-10);
    };
    expect(0.1, 0.9374755799499051);
    expect(1.0, 0.5936242600400401);
    expect(10.0, 0.09998162475294389);
  }
}

// What the models make of 0.5; the numbers have seven and eight digits. Then the exact inversion.
TEST(HardCases, S3EffectiveRestitution) {
  const auto restitution = [](ContactModel model, double asked, bool exact) {
    Spring stop;
    stop.stiffness = 2e8;
    stop.damping.emplace();
    stop.damping->model = model;
    stop.damping->restitution = asked;
    stop.damping->speed = 0.3;
    stop.damping->exact = exact;
    return encounter(spring_law(stop), 0.5, 0.3, 1e-3).separation.effective_restitution.value();
  };
  const auto expect = [&](ContactModel model, const char* row, double e, double allowed) {
    expect_reached("S3", row, support::off(restitution(model, 0.5, false), e), allowed);
  };
  expect(ContactModel::kHuntCrossley, "asked for 0.5: Hunt and Crossley", 0.6629622, 5e-8);
  expect(ContactModel::kLankaraniNikravesh, "asked for 0.5: Lankarani and Nikravesh", 0.72524111,
         5e-9);
  expect(ContactModel::kFlores, "asked for 0.5: Flores et al.", 0.47044478, 5e-9);
  for (const double asked : {0.9, 0.5, 0.1})
    expect_reached("S3", "exact inversion: e",
                   support::off(restitution(ContactModel::kHuntCrossley, asked, true), asked),
                   1e-10);
}

// data/scenes/15_sphere_on_a_beam.toml, with 25 modes of the beam; the numbers have seven and six
// digits. Without damping the energy is that of the approach.
TEST(HardCases, S5SphereOnABeam) {
  const Scene scene = support::shipped_scene("15_sphere_on_a_beam");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const auto run = support::record_run(system, start, support::for_seconds(3e-4));
  ASSERT_EQ(run.result.outcome, RunOutcome::kReachedEnd) << run.result.message;
  ASSERT_EQ(run.events.size(), 2u);
  expect_reached("S5", "sphere on a beam: largest force, N",
                 support::off(run.events[1].peak_force, 4.842663), 5e-7);
  expect_reached("S5", "release, s", support::off(run.events[1].time, 158.519e-6), 5e-10);
  const State& end = run.result.final;
  const double energy = end.qdot.squaredNorm() + system.omega.cwiseProduct(end.q).squaredNorm();
  expect_reached("S5", "energy, relative", relative(energy, start.qdot.squaredNorm()), 1e-10);
}

}  // namespace
}  // namespace graze
