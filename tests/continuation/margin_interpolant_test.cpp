// Where the smallest of several quantities may change sign between two points of a branch.
#include "graze/continuation/special/detail/margin_interpolant.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

// c + (s - at)^2 k, on the piece.
MarginInterpolant parabola(double c, double at, double k) {
  return MarginInterpolant::between(c + k * at * at, -2.0 * k * at, c + k * (1.0 - at) * (1.0 - at),
                                    2.0 * k * (1.0 - at));
}

MarginInterpolant line(double start, double end) {
  return MarginInterpolant::between(start, end - start, end, end - start);
}

TEST(MarginInterpolant, IsTheCubicThroughBothEnds) {
  // 2 - s + 3 s^2 - 5 s^3
  const MarginInterpolant interpolant = MarginInterpolant::between(2.0, -1.0, -1.0, -10.0);
  for (const double s : {0.0, 0.2, 0.7, 1.0})
    EXPECT_NEAR(interpolant.at(s), 2.0 - s + 3.0 * s * s - 5.0 * s * s * s, 1e-15);
  EXPECT_EQ(interpolant.error(0.0), 0.0);
  EXPECT_EQ(interpolant.error(1.0), 0.0);
}

TEST(MarginInterpolant, ADipBelowZeroIsLookedAtWhereItIsDeepest) {
  for (const double depth : {1.0, 1e-3, 1e-9}) {
    const auto place = suspected_sign_change({parabola(-depth, 0.3, 1e2)});
    ASSERT_TRUE(place);
    EXPECT_NEAR(*place, 0.3, 1e-12);
  }
}

TEST(MarginInterpolant, ADipThatMayReachZeroIsLookedAt) {
  EXPECT_TRUE(suspected_sign_change({parabola(0.05, 0.5, 1.0)}));
  EXPECT_TRUE(suspected_sign_change({parabola(-0.05, 0.5, -1.0)})) << "a rise above";
}

TEST(MarginInterpolant, WhatStaysClearIsNot) {
  EXPECT_FALSE(suspected_sign_change({}));
  EXPECT_FALSE(suspected_sign_change({parabola(0.5, 0.5, 1.0)}));
  EXPECT_FALSE(suspected_sign_change({parabola(-0.5, 0.5, -1.0)}));
  EXPECT_FALSE(suspected_sign_change({line(1.0, 2.0), line(3.0, 1.0)}));
}

TEST(MarginInterpolant, OneChangeThatTheEndsShowIsNot) {
  EXPECT_FALSE(suspected_sign_change({line(1.0, -2.0)}));
  EXPECT_FALSE(suspected_sign_change({line(-1.0, 2.0), line(3.0, 1.0)}));
}

// One recovers at 1/4 before another is lost at 1/2.
TEST(MarginInterpolant, AShortStayBetweenTwoQuantitiesIsLookedAt) {
  const auto place = suspected_sign_change({line(-1.0, 3.0), line(1.0, -1.0)});
  ASSERT_TRUE(place);
  EXPECT_GT(*place, 0.25);
  EXPECT_LT(*place, 0.5);
  EXPECT_FALSE(suspected_sign_change({line(-1.0, 1.0), line(1.0, -3.0)})) << "lost before";
}

// Both vanish at about the middle, -0.02 there: less than what they are known to.
TEST(MarginInterpolant, AnOrderThatIsNotKnownIsLookedAt) {
  const MarginInterpolant rising = MarginInterpolant::between(-1.12, 2.4, 0.88, 1.6);
  const MarginInterpolant falling = MarginInterpolant::between(0.88, -1.6, -1.12, -2.4);
  ASSERT_TRUE(suspected_sign_change({rising, falling}));
}

TEST(MarginInterpolant, OfAQuantityKnownAtOneEndHalfThePieceIsAsked) {
  EXPECT_TRUE(suspected_sign_change({line(1.0, 1.0), MarginInterpolant::from_start(0.1, -1.0)}));
  EXPECT_FALSE(suspected_sign_change({line(1.0, 1.0), MarginInterpolant::from_start(2.0, -1.0)}));
  EXPECT_TRUE(suspected_sign_change({line(1.0, 1.0), MarginInterpolant::to_end(0.1, 1.0)}));
}

TEST(MarginInterpolant, WithinRoundingNothingIsTold) {
  MarginInterpolant interpolant = parabola(-1e-14, 0.5, 1e-13);
  interpolant.rounding = 1e-12;
  EXPECT_FALSE(suspected_sign_change({interpolant}));
}

}  // namespace
}  // namespace graze
