// Branches whose unknowns have ranges.
#include <gtest/gtest.h>

#include <cmath>

#include "known_problems.hpp"

namespace graze {
namespace {

// u^2 + p^2 = 1
ZeroProblem limited_circle() {
  return support::scalar_problem([](double u, double p) {
    return support::Scalar{u * u + p * p - 1.0, 2.0 * u, 2.0 * p};
  });
}

TEST(UnknownRanges, BranchesEndWhereAnUnknownLeavesItsRange) {
  ContinuationOptions options = support::range(-2.0, 2.0);
  options.ranges = {{0, 0.5, -3.0, 0.0}};
  const Branch branch = support::traced(limited_circle(), options, -0.9, 0.3);
  for (const BranchEnd end : branch.ends) EXPECT_EQ(end, BranchEnd::kUnknownLimit);
  EXPECT_EQ(branch.points.front().u[0], 0.5);
  EXPECT_EQ(branch.points.back().u[0], 0.5);
  EXPECT_NEAR(branch.points.front().parameter * branch.points.back().parameter, -0.75, 1e-14);
  // It comes back after a short way beyond.
  for (const double limit : {-0.99, -0.9999, -0.999999}) {
    SCOPED_TRACE(limit);
    options.ranges = {{0, limit, 3.0, 0.0}};
    const Branch cut = support::traced(limited_circle(), options, 0.9, 0.3);
    for (const BranchEnd end : cut.ends) EXPECT_EQ(end, BranchEnd::kUnknownLimit);
    EXPECT_EQ(cut.points.front().u[0], limit);
    EXPECT_EQ(cut.points.back().u[0], limit);
  }
}

// Along the tangent; a step of length h <= 0.1 bends away from it by h^2/2.
TEST(UnknownRanges, StepsOfAnUnknownAreBounded) {
  ContinuationOptions options = support::range(-2.0, 2.0);
  options.ranges = {{0, -3.0, 3.0, 0.01}};
  const Branch branch = support::traced(limited_circle(), options, 0.9, 0.3);
  EXPECT_TRUE(branch.closed());
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
    EXPECT_LE(std::abs(branch.points[i + 1].u[0] - branch.points[i].u[0]), 0.015);
}

}  // namespace
}  // namespace graze
