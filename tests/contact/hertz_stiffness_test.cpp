#include "graze/contact/hertz_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace graze {
namespace {

constexpr double kFlat = std::numeric_limits<double>::infinity();

ElasticBody ball(double radius, double modulus, double nu) {
  return {{radius, radius}, modulus, nu};
}

TEST(HertzStiffness, OfTwoSpheres) {
  const double e = 1.0 / (0.91 / 70e9 + 0.9375 / 210e9), r = 1.0 / (1.0 / 5e-3 + 1.0 / 20e-3);
  const auto k = hertz_stiffness(ball(5e-3, 70e9, 0.3), ball(20e-3, 210e9, 0.25));
  ASSERT_TRUE(k);
  EXPECT_NEAR(*k / (4.0 / 3.0 * e * std::sqrt(r)), 1.0, 4e-15);
}

// Yigit, Ulsoy & Scott (1990): spheres of 6.3 and 12.6 mm give 3.27e9; the curvatures 1/(2 R1) and
// 1/(2 R2), those of crossed cylinders, 4.82e9.
TEST(HertzStiffness, OfThePaper) {
  const auto spheres = hertz_stiffness(ball(6.3e-3, 68.95e9, 0.3), ball(12.6e-3, 68.95e9, 0.3));
  ASSERT_TRUE(spheres);
  EXPECT_NEAR(*spheres, 3.27e9, 0.005e9);
  const ElasticBody thin{{6.3e-3, kFlat}, 68.95e9, 0.3}, thick{{12.6e-3, kFlat}, 68.95e9, 0.3};
  const auto crossed = hertz_stiffness(thin, thick, std::numbers::pi / 2.0);
  ASSERT_TRUE(crossed);
  EXPECT_NEAR(*crossed, 4.82e9, 0.005e9);
}

// Timoshenko's steel sphere on a flat beam: (2/3) E/(1 - nu^2) sqrt(R).
TEST(HertzStiffness, OfASphereOnAPlane) {
  const auto k = hertz_stiffness(ball(0.01, 206e9, 0.3), ElasticBody{{kFlat, kFlat}, 206e9, 0.3});
  ASSERT_TRUE(k);
  EXPECT_NEAR(*k / 1.5091575091575e10, 1.0, 1e-13);
}

// Equal cylinders crossed at right angles touch as a sphere of that radius on a plane.
TEST(HertzStiffness, OfCrossedCylinders) {
  const ElasticBody rod{{0.01, kFlat}, 206e9, 0.3};
  const auto k = hertz_stiffness(rod, rod, std::numbers::pi / 2.0);
  ASSERT_TRUE(k);
  EXPECT_NEAR(*k / 1.5091575091575e10, 1.0, 1e-13);
  // At another angle the ellipse is longer and the contact stiffer or softer, continuously.
  const auto near = hertz_stiffness(rod, rod, std::numbers::pi / 2.0 - 1e-7);
  ASSERT_TRUE(near);
  EXPECT_NEAR(*near / *k, 1.0, 1e-7);
}

// The ellipse whose axes are as 2 to 1: e^2 = 3/4. With 30 digits, K = 2.15651564749964323,
// E = 1.21105602756845953, so B/A = (4E - K)/(K - E) and k by the formula of the header.
TEST(HertzStiffness, OfAnEllipticContact) {
  const double k = 2.15651564749964323, e = 1.21105602756845953;
  const double a = 50.0, b = a * (4.0 * e - k) / (k - e);
  // A body of radii 1/(2A), 1/(2B) on a rigid plane.
  const auto found = hertz_stiffness(ElasticBody{{0.5 / a, 0.5 / b}, 100e9, 0.0},
                                     ElasticBody{{kFlat, kFlat}, 1e30, 0.0});
  ASSERT_TRUE(found);
  const double meant =
      2.0 * std::numbers::pi * 100e9 / 3.0 * std::pow(k, -1.5) * std::sqrt((k - e) / (0.75 * a));
  EXPECT_NEAR(*found / meant, 1.0, 1e-13);
}

TEST(HertzStiffness, NothingWithoutAPointOfContact) {
  const ElasticBody plane{{kFlat, kFlat}, 1e9, 0.3}, rod{{0.01, kFlat}, 1e9, 0.3};
  EXPECT_FALSE(hertz_stiffness(plane, plane));
  EXPECT_FALSE(hertz_stiffness(rod, rod));                                     // side by side
  EXPECT_FALSE(hertz_stiffness(ball(0.02, 1e9, 0.3), ball(-0.01, 1e9, 0.3)));  // does not fit in
  EXPECT_TRUE(hertz_stiffness(ball(0.01, 1e9, 0.3), ball(-0.02, 1e9, 0.3)));
}

}  // namespace
}  // namespace graze
