// Damping and restitution against closed forms; the numbers with many digits were computed with 40
// digits from the same equations (hard cases S2, S3).
#include "graze/contact/detail/restitution_damping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace graze {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

TEST(SpringDashpot, LosesMoreWhereItPartsAtZeroDepth) {
  EXPECT_NEAR(restitution_at_zero_depth(0.3), 0.372326104926586, 1e-15);
  EXPECT_NEAR(restitution_at_zero_force(0.3), 0.450975452893128, 1e-15);
  EXPECT_EQ(restitution_at_zero_depth(0.0), 1.0);
  EXPECT_EQ(restitution_at_zero_force(0.0), 1.0);
}

// Critically damped: x = v t e^{-w t}, and F = -x'' = 0 at t = 2/w, where x' = -v e^{-2}.
TEST(SpringDashpot, AtAndBeyondCriticalDamping) {
  EXPECT_NEAR(restitution_at_zero_force(1.0), std::exp(-2.0), 1e-16);
  EXPECT_EQ(restitution_at_zero_depth(1.0), 0.0);
  EXPECT_EQ(restitution_at_zero_depth(3.0), 0.0);
  // zeta = 5/4: rates -1/2 and -2. x' = (4 e^{-2t} - e^{-t/2})/3, x'' = 0 where e^{3t/2} = 16.
  const double t = std::log(16.0) / 1.5;
  const double e = (std::exp(-0.5 * t) - 4.0 * std::exp(-2.0 * t)) / 3.0;
  EXPECT_NEAR(restitution_at_zero_force(1.25), e, 1e-15);
  // Both sides of 1 meet.
  EXPECT_NEAR(restitution_at_zero_force(1.0 - 1e-9), std::exp(-2.0), 1e-9);
  EXPECT_NEAR(restitution_at_zero_force(1.0 + 1e-9), std::exp(-2.0), 1e-9);
}

TEST(SpringDashpot, InversionsReturnTheRestitution) {
  for (const double e : {1.0, 0.999999, 0.9, 0.5, 0.2, std::exp(-2.0), 0.05, 1e-4}) {
    EXPECT_NEAR(restitution_at_zero_depth(damping_ratio_of(e)), e, 4e-15) << e;
    EXPECT_NEAR(restitution_at_zero_force(damping_ratio_at_zero_force(e)), e, 4e-15) << e;
  }
}

TEST(PowerDamping, RestitutionByTheMeetingSpeed) {
  EXPECT_NEAR(restitution_of_power_damping(0.1), 0.9374755799499051, 4.0 * kEps);
  EXPECT_NEAR(restitution_of_power_damping(1.0), 0.5936242600400401, 4.0 * kEps);
  EXPECT_NEAR(restitution_of_power_damping(10.0), 0.09998162475294389, 0.4 * kEps);
  // e = 1 - 2A/3 + .. for little damping, 1/A for much.
  EXPECT_EQ(restitution_of_power_damping(0.0), 1.0);
  EXPECT_NEAR(1.0 - restitution_of_power_damping(1e-6), 2e-6 / 3.0, 1e-12);
  EXPECT_NEAR(restitution_of_power_damping(1e6) * 1e6, 1.0, 1e-15);
}

TEST(PowerDamping, WhatTheModelsGiveForOneHalf) {
  EXPECT_NEAR(restitution_of_power_damping(hunt_crossley_damping(0.5)), 0.6629622, 5e-8);
  EXPECT_NEAR(restitution_of_power_damping(lankarani_nikravesh_damping(0.5)), 0.72524111, 5e-9);
  EXPECT_NEAR(restitution_of_power_damping(flores_damping(0.5)), 0.47044478, 5e-9);
}

TEST(PowerDamping, InversionReturnsTheRestitution) {
  for (const double e : {1.0, 1.0 - 1e-9, 0.99, 0.9, 0.5, 0.1, 0.01, 1e-5}) {
    const double a = power_damping_of(e);
    EXPECT_NEAR(restitution_of_power_damping(a), e, 4e-15) << e;
  }
  EXPECT_NEAR(power_damping_of(1.0 - 1e-9), 1.5e-9, 1e-15);  // A = 3(1 - e)/2 + ..
  for (int i = 1; i < 1000; ++i) {
    const double e = 0.001 * i;
    EXPECT_NEAR(restitution_of_power_damping(power_damping_of(e)), e, 4e-15) << e;
  }
}

}  // namespace
}  // namespace graze
