// Where the smallest of several quantities may change sign between two points of a branch.
#include "graze/continuation/special/detail/margin_course.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

// c + (s - at)^2 k, on the piece.
MarginCourse parabola(double c, double at, double k) {
  return MarginCourse::between(c + k * at * at, -2.0 * k * at, c + k * (1.0 - at) * (1.0 - at),
                               2.0 * k * (1.0 - at));
}

MarginCourse line(double start, double end) {
  return MarginCourse::between(start, end - start, end, end - start);
}

TEST(MarginCourse, IsTheCubicThroughBothEnds) {
  // 2 - s + 3 s^2 - 5 s^3
  const MarginCourse course = MarginCourse::between(2.0, -1.0, -1.0, -10.0);
  for (const double s : {0.0, 0.2, 0.7, 1.0})
    EXPECT_NEAR(course.at(s), 2.0 - s + 3.0 * s * s - 5.0 * s * s * s, 1e-15);
  EXPECT_EQ(course.error(0.0), 0.0);
  EXPECT_EQ(course.error(1.0), 0.0);
}

TEST(MarginCourse, ADipBelowZeroIsLookedAtWhereItIsDeepest) {
  for (const double depth : {1.0, 1e-3, 1e-9}) {
    const auto place = doubt_within({parabola(-depth, 0.3, 1e2)});
    ASSERT_TRUE(place);
    EXPECT_NEAR(*place, 0.3, 1e-12);
  }
}

TEST(MarginCourse, ADipThatMayReachZeroIsLookedAt) {
  EXPECT_TRUE(doubt_within({parabola(0.05, 0.5, 1.0)}));
  EXPECT_TRUE(doubt_within({parabola(-0.05, 0.5, -1.0)})) << "a rise above";
}

TEST(MarginCourse, WhatStaysClearIsNot) {
  EXPECT_FALSE(doubt_within({}));
  EXPECT_FALSE(doubt_within({parabola(0.5, 0.5, 1.0)}));
  EXPECT_FALSE(doubt_within({parabola(-0.5, 0.5, -1.0)}));
  EXPECT_FALSE(doubt_within({line(1.0, 2.0), line(3.0, 1.0)}));
}

TEST(MarginCourse, OneChangeThatTheEndsShowIsNot) {
  EXPECT_FALSE(doubt_within({line(1.0, -2.0)}));
  EXPECT_FALSE(doubt_within({line(-1.0, 2.0), line(3.0, 1.0)}));
}

// One recovers at 1/4 before another is lost at 1/2.
TEST(MarginCourse, AShortStayBetweenTwoQuantitiesIsLookedAt) {
  const auto place = doubt_within({line(-1.0, 3.0), line(1.0, -1.0)});
  ASSERT_TRUE(place);
  EXPECT_GT(*place, 0.25);
  EXPECT_LT(*place, 0.5);
  EXPECT_FALSE(doubt_within({line(-1.0, 1.0), line(1.0, -3.0)})) << "lost before";
}

// Both vanish at about the middle, -0.02 there: less than what they are known to.
TEST(MarginCourse, AnOrderThatIsNotKnownIsLookedAt) {
  const MarginCourse rising = MarginCourse::between(-1.12, 2.4, 0.88, 1.6);
  const MarginCourse falling = MarginCourse::between(0.88, -1.6, -1.12, -2.4);
  ASSERT_TRUE(doubt_within({rising, falling}));
}

TEST(MarginCourse, OfAQuantityKnownAtOneEndHalfThePieceIsAsked) {
  EXPECT_TRUE(doubt_within({line(1.0, 1.0), MarginCourse::from_start(0.1, -1.0)}));
  EXPECT_FALSE(doubt_within({line(1.0, 1.0), MarginCourse::from_start(2.0, -1.0)}));
  EXPECT_TRUE(doubt_within({line(1.0, 1.0), MarginCourse::to_end(0.1, 1.0)}));
}

TEST(MarginCourse, WithinRoundingNothingIsTold) {
  MarginCourse course = parabola(-1e-14, 0.5, 1e-13);
  course.rounding = 1e-12;
  EXPECT_FALSE(doubt_within({course}));
}

}  // namespace
}  // namespace graze
