#include "graze/base/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace graze {
namespace {

// Far from zero an angle is known to its last digit, and so is its sine; what brings it back must
// not lose that.
TEST(Angle, NearZeroKeepsSineAndCosine) {
  for (const double theta : {1e8, -3e15, 7.0, -6.5, 1e300}) {
    const double near = near_zero(theta);
    EXPECT_LE(std::abs(near), kTurn) << theta;
    EXPECT_NEAR(std::sin(near), std::sin(theta), 2.0 * std::numeric_limits<double>::epsilon());
    EXPECT_NEAR(std::cos(near), std::cos(theta), 2.0 * std::numeric_limits<double>::epsilon());
  }
}

TEST(Angle, NearZeroLeavesWhatIsNear) {
  for (const double theta : {0.0, 1.0, -3.0, 6.28, kTurn, -kTurn})
    EXPECT_EQ(near_zero(theta), theta);
}

TEST(Angle, WrappedLiesInOneTurn) {
  for (const double theta : {-1e-17, 0.0, 1.0, -1.0, 100.0, kTurn}) {
    const double phase = wrapped(theta);
    EXPECT_GE(phase, 0.0) << theta;
    EXPECT_LT(phase, kTurn) << theta;
  }
}

}  // namespace
}  // namespace graze
