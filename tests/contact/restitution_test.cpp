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
    EXPECT_EQ(r.slope_at(v), 0.0);
    EXPECT_FALSE(r.clamps_at(v));
  }
}

TEST(Restitution, FallsAsItsPolynomial) {
  const Restitution r(std::vector<double>{0.9, 0.25, -0.125, 0.5});
  EXPECT_FALSE(r.is_constant());
  EXPECT_EQ(r.at_rest(), 0.9);
  // .9 - .25/2 + .125/4 - .5/8
  EXPECT_DOUBLE_EQ(r.at(0.5), 0.9 - 0.125 + 0.03125 - 0.0625);
  EXPECT_DOUBLE_EQ(r.slope_at(0.5), -0.25 + 0.125 - 0.375);
}

TEST(Restitution, IsClampedToZeroAndOne) {
  const Restitution falling(std::vector<double>{0.8, 1.0});
  EXPECT_EQ(falling.at(0.9), 0.0);
  EXPECT_TRUE(falling.clamps_at(0.9));
  EXPECT_EQ(falling.slope_at(0.9), 0.0);
  EXPECT_EQ(falling.rate_at(0.9, Restitution(std::vector<double>{1.0, 0.0})), 0.0);
  const Restitution rising(std::vector<double>{0.8, -1.0});
  EXPECT_EQ(rising.at(0.5), 1.0);
  EXPECT_FALSE(rising.clamps_at(0.1));
  EXPECT_DOUBLE_EQ(rising.rate_at(0.1, Restitution(std::vector<double>{0.0, 1.0})), -0.1);
}

}  // namespace
}  // namespace graze
