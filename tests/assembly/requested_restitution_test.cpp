// Restitution asked for and given: closed forms; published numbers where the models ask for 0.5.
#include "graze/assembly/detail/requested_restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace graze {
namespace {

constexpr double kStiffness = 3e9;  // N/m^1.5, and N/m of the linear one

Spring spring_of(ContactModel model, double restitution, double exponent) {
  Spring spring;
  spring.stiffness = kStiffness;
  spring.exponent = exponent;
  spring.damping.emplace();
  spring.damping->model = model;
  spring.damping->restitution = restitution;
  return spring;
}

Spring power_spring(ContactModel model, double restitution) {
  Spring spring = spring_of(model, restitution, 1.5);
  spring.damping->speed = 0.2;
  return spring;
}

Spring dashpot(double restitution, Separation release) {
  Spring spring = spring_of(ContactModel::kKelvinVoigt, restitution, 1.0);
  spring.damping->mass = 0.3;
  spring.release = release;
  return spring;
}

TEST(RequestedRestitution, OfDampingThatGrowsWithTheForce) {
  const auto expect = [](ContactModel model, double effective, double within) {
    const auto asked = requested_restitution(power_spring(model, 0.5));
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->requested, 0.5);
    EXPECT_EQ(asked->speed, 0.2);
    EXPECT_FALSE(asked->mass);
    EXPECT_NEAR(asked->effective, effective, within);
    // A (1 + e) = ln[(1 + A)/(1 - A e)] at e = 1/2, A = C v/k.
    const double a = asked->exact_coefficient.value() * 0.2 / kStiffness;
    EXPECT_NEAR(1.5 * a, std::log((1.0 + a) / (1.0 - 0.5 * a)), 1e-14);
    EXPECT_GT(a, 0.5);
  };
  expect(ContactModel::kHuntCrossley, 0.6629622, 5e-8);
  expect(ContactModel::kLankaraniNikravesh, 0.72524111, 5e-9);
  expect(ContactModel::kFlores, 0.47044478, 5e-9);
}

// ln e = -2 zeta arccos(zeta)/sqrt(1 - zeta^2) at zero force, -pi zeta/sqrt(1 - zeta^2) at zero
// depth; C = 2 zeta sqrt(k m).
TEST(RequestedRestitution, OfASpringDashpot) {
  const double e = 0.372326104926586, zeta = 0.3;  // hard case S2
  const double c = 2.0 * zeta * std::sqrt(kStiffness * 0.3);
  const auto depth = requested_restitution(dashpot(e, Separation::kAtZeroDepth));
  ASSERT_TRUE(depth);
  EXPECT_NEAR(depth->effective, e, 1e-14);
  EXPECT_NEAR(depth->exact_coefficient.value() / c, 1.0, 1e-14);
  EXPECT_EQ(depth->mass, 0.3);
  EXPECT_FALSE(depth->speed);
  const auto force = requested_restitution(dashpot(e, Separation::kAtZeroForce));
  ASSERT_TRUE(force);
  EXPECT_NEAR(force->effective, 0.450975452893128, 1e-14);
  const double more = force->exact_coefficient.value() / c * zeta;
  EXPECT_NEAR(-2.0 * more * std::acos(more) / std::sqrt(1.0 - more * more), std::log(e), 1e-14);
}

TEST(RequestedRestitution, IsMetByTheExactInversion) {
  for (const double e : {0.9, 0.5, 0.1}) {
    for (const ContactModel model : {ContactModel::kHuntCrossley, ContactModel::kFlores}) {
      Spring spring = power_spring(model, e);
      spring.damping->exact = true;
      EXPECT_NEAR(requested_restitution(spring)->effective, e, 1e-14);
    }
    Spring spring = dashpot(e, Separation::kAtZeroForce);
    spring.damping->exact = true;
    EXPECT_NEAR(requested_restitution(spring)->effective, e, 1e-14);
  }
}

// Deep contacts of the second model of Lee and Wang are Kelvin-Voigt's.
TEST(RequestedRestitution, OfDampingThatSetsIn) {
  Spring spring = spring_of(ContactModel::kLeeWang2, 0.5, 1.0);
  spring.damping->mass = 0.1;
  spring.damping->onset = 1e-6;
  spring.release = Separation::kAtZeroDepth;
  const auto asked = requested_restitution(spring);
  ASSERT_TRUE(asked);
  EXPECT_NEAR(asked->effective, 0.5, 1e-15);
  EXPECT_FALSE(asked->exact_coefficient);
}

TEST(RequestedRestitution, IsAbsentWhereNoneWasAskedFor) {
  Spring spring = power_spring(ContactModel::kHuntCrossley, 0.5);
  spring.damping->restitution.reset();
  spring.damping->coefficient = 1e6;
  EXPECT_FALSE(requested_restitution(spring));
  spring.damping.reset();
  EXPECT_FALSE(requested_restitution(spring));
}

}  // namespace
}  // namespace graze
