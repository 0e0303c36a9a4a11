// r(v) = a0 - a1 v - a2 v^2 - ..: values, slope, clamping.
#include "graze/contact/restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graze {
namespace {

TEST(Restitution, OfANumberIsConstant) {
  const Restitution r = 0.7;
  EXPECT_TRUE(r.is_constant());
  for (const double v : {0.0, 0.3, 1e9, -2.0}) {
    EXPECT_EQ(r.at(v), 0.7);
    EXPECT_EQ(r.jump(v), 1.7 * v);
    EXPECT_EQ(r.jump_slope(v), 1.7);
    EXPECT_EQ(r.jump_bend(v), 0.0);
    EXPECT_FALSE(r.clamps_at(v));
  }
}

TEST(Restitution, FallsAsItsPolynomial) {
  const Restitution r(std::vector<double>{0.9, 0.25, -0.125, 0.5});
  EXPECT_FALSE(r.is_constant());
  EXPECT_EQ(r.at_rest(), 0.9);
  // .9 - .25/2 + .125/4 - .5/8
  EXPECT_DOUBLE_EQ(r.at(0.5), 0.9 - 0.125 + 0.03125 - 0.0625);
  // 1.9 v - .25 v^2 + .125 v^3 - .5 v^4 and its derivatives.
  EXPECT_DOUBLE_EQ(r.jump(0.5), 0.95 - 0.0625 + 0.015625 - 0.03125);
  EXPECT_DOUBLE_EQ(r.jump_slope(0.5), 1.9 - 0.25 + 0.09375 - 0.25);
  EXPECT_DOUBLE_EQ(r.jump_bend(0.5), -0.5 + 0.375 - 1.5);
  // Along a1: -v^2 of the jump, -2 v of its slope.
  const Restitution rates(std::vector<double>{0.0, 1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(r.jump_rate(0.5, rates), -0.25);
  EXPECT_DOUBLE_EQ(r.jump_slope_rate(0.5, rates), -1.0);
}

TEST(Restitution, IsClampedToZeroAndOne) {
  const Restitution falling(std::vector<double>{0.8, 1.0});
  EXPECT_EQ(falling.at(0.9), 0.0);
  EXPECT_TRUE(falling.clamps_at(0.9));
  EXPECT_EQ(falling.jump_slope(0.9), 1.0);
  EXPECT_EQ(falling.jump_bend(0.9), 0.0);
  EXPECT_EQ(falling.jump_rate(0.9, Restitution(std::vector<double>{1.0, 0.0})), 0.0);
  const Restitution rising(std::vector<double>{0.8, -1.0});
  EXPECT_EQ(rising.at(0.5), 1.0);
  EXPECT_FALSE(rising.clamps_at(0.1));
  EXPECT_DOUBLE_EQ(rising.jump_rate(0.1, Restitution(std::vector<double>{0.0, 1.0})), -0.01);
}

}  // namespace
}  // namespace graze
