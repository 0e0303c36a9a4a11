// Curves in a plane of two parameters that have nothing to do with multipliers.
#include "graze/continuation/locus/detail/plane_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// v = p - q on the ellipse p^2/4 + q^2 = 1, with the unknown (v, p/range).
PlaneCurveProblem ellipse(double range) {
  PlaneCurveProblem curve;
  curve.first = 1;
  curve.problem.evaluate = [range](const Vector& y, Parameters parameters) {
    const double q = parameters[0];
    const double p = range * y[1];
    ZeroEvaluation at{Vector(2), Matrix(2, 2), Vector(2)};
    at.residual << y[0] - p + q, 0.25 * p * p + q * q - 1.0;
    at.jacobian << 1.0, -range, 0.0, 0.5 * p * range;
    at.by_parameters << 1.0, 2.0 * q;
    return std::optional<ZeroEvaluation>(at);
  };
  curve.tests.all = [](const SolutionPoint&, const SolutionPoint& at) {
    return std::optional<Vector>(Vector{{at.u[0], at.parameter - 0.6}});
  };
  return curve;
}

LocusOptions window(double p0, double p1, double q0, double q1) {
  LocusOptions options;
  options.first_from = p0;
  options.first_to = p1;
  options.second_from = q0;
  options.second_to = q1;
  return options;
}

TEST(PlaneCurves, ZerosOfTestsAreLocated) {
  const LocusOptions options = window(-5.0, 3.0, -2.0, 2.0);
  const PlaneCurveProblem problem = ellipse(first_range(options));
  const auto start = point_on_curve(problem, options, Vector{{1.0, 1.9 / 8.0}}, 0.3);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->parameter, 0.3);
  const PlaneCurve curve = trace_curve(problem, options, *start);
  EXPECT_TRUE(curve.branch.closed());
  ASSERT_EQ(curve.zeros.size(), 4u);
  for (const TestZero& zero : curve.zeros) {
    const double p = 8.0 * zero.point.u[1], q = zero.point.parameter;
    EXPECT_NEAR(std::abs(q), zero.test == 0 ? 2.0 / std::sqrt(5.0) : 0.6, 1e-13);
    EXPECT_NEAR(std::abs(p), zero.test == 0 ? 2.0 / std::sqrt(5.0) : 1.6, 1e-13);
  }
}

TEST(PlaneCurves, AreCutByBothRanges) {
  const LocusOptions options = window(-0.8, 3.0, -2.0, 0.6);
  const PlaneCurveProblem problem = ellipse(first_range(options));
  // Upright there: at its p.
  const auto start = point_on_curve(problem, options, Vector{{1.9, 2.0 / 3.8}}, 0.001);
  ASSERT_TRUE(start);
  const PlaneCurve curve = trace_curve(problem, options, *start);
  std::vector<BranchEnd> ends(curve.branch.ends.begin(), curve.branch.ends.end());
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(ends, (std::vector<BranchEnd>{BranchEnd::kParameterLimit, BranchEnd::kUnknownLimit}));
  const bool first = curve.branch.ends[0] == BranchEnd::kUnknownLimit;
  EXPECT_EQ(curve.left_range[first ? 0 : 1], 1);
  const SolutionPoint& cut = first ? curve.branch.points.front() : curve.branch.points.back();
  EXPECT_EQ(cut.u[1], -0.8 / 3.8);
  EXPECT_NEAR(cut.parameter, -std::sqrt(0.84), 1e-13);
}

}  // namespace
}  // namespace graze
