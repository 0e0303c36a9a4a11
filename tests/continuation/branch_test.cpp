// Pseudo-arclength continuation on problems whose branches are known.
#include "graze/continuation/branch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "known_problems.hpp"

namespace graze {
namespace {

using support::range;
using support::Scalar;
using support::scalar_problem;
using support::traced;

ZeroProblem circle() {
  return scalar_problem([](double u, double p) {
    return Scalar{u * u + p * p - 1.0, 2.0 * u, 2.0 * p};
  });
}

// p = u^3 - 3 s u: folds at p = -+2 s^1.5, u = +-sqrt(s).
ZeroProblem cubic(double s) {
  return scalar_problem([s](double u, double p) {
    return Scalar{u * u * u - 3.0 * s * u - p, 3.0 * (u * u - s), -1.0};
  });
}

TEST(Continuation, CircleClosesOnceWithTwoFolds) {
  const Branch branch = traced(circle(), range(-2.0, 2.0), 1.0, 0.1);
  ASSERT_TRUE(branch.closed());
  EXPECT_EQ(branch.ends[0], BranchEnd::kClosed);
  EXPECT_NEAR(branch.points.front().u[0], branch.points.back().u[0], 1e-7);
  EXPECT_NEAR(branch.points.front().parameter, branch.points.back().parameter, 1e-7);
  double turned = 0.0;
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    const SolutionPoint& point = branch.points[i];
    EXPECT_NEAR(std::hypot(point.u[0], point.parameter), 1.0, 1e-11);
    if (i == 0) continue;
    const SolutionPoint& last = branch.points[i - 1];
    turned += std::remainder(
        std::atan2(point.parameter, point.u[0]) - std::atan2(last.parameter, last.u[0]),
        2.0 * std::numbers::pi);
  }
  EXPECT_NEAR(std::abs(turned), 2.0 * std::numbers::pi, 1e-6);
  ASSERT_EQ(branch.critical_of(CriticalKind::kFold).size(), 2u);
  for (const CriticalPoint& fold : branch.critical_of(CriticalKind::kFold)) {
    EXPECT_NEAR(std::abs(fold.point.parameter), 1.0, 1e-13);
    EXPECT_NEAR(fold.point.u[0], 0.0, 1e-7);
  }
}

TEST(Continuation, RangeIsTheSameInEitherOrder) {
  const Branch branch = traced(circle(), range(2.0, -2.0), 1.0, 0.1);
  EXPECT_TRUE(branch.closed());
  EXPECT_EQ(branch.critical_of(CriticalKind::kFold).size(), 2u);
}

TEST(Continuation, CuspHasItsTwoFoldsAndEndsAtBothLimits) {
  const Branch branch = traced(cubic(1.0), range(-5.0, 5.0), 2.1, 3.0);
  EXPECT_EQ(branch.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(branch.ends[1], BranchEnd::kParameterLimit);
  // To the last bit.
  EXPECT_EQ(std::min(branch.points.front().parameter, branch.points.back().parameter), -5.0);
  EXPECT_EQ(std::max(branch.points.front().parameter, branch.points.back().parameter), 5.0);
  ASSERT_EQ(branch.critical_of(CriticalKind::kFold).size(), 2u);
  for (const CriticalPoint& fold : branch.critical_of(CriticalKind::kFold)) {
    EXPECT_NEAR(std::abs(fold.point.parameter), 2.0, 1e-13);
    EXPECT_NEAR(fold.point.u[0], fold.point.parameter > 0.0 ? -1.0 : 1.0, 1e-7);
    const double before = branch.points[fold.after].u[0],
                 after = branch.points[fold.after + 1].u[0];
    EXPECT_LE((fold.point.u[0] - before) * (fold.point.u[0] - after), 0.0);
  }
}

TEST(Continuation, LimitBetweenTheFoldsEndsTheBranchThere) {
  const Branch branch = traced(cubic(1.0), range(-1.0, 5.0), 2.1, 3.0);
  EXPECT_EQ(branch.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(branch.ends[1], BranchEnd::kParameterLimit);
  EXPECT_TRUE(branch.critical_of(CriticalKind::kFold)
                  .empty());  // the upper family leaves at p = -1, before its fold at -2
  for (const SolutionPoint& point : branch.points) {
    EXPECT_GE(point.parameter, -1.0);
    EXPECT_LE(point.parameter, 5.0);
    EXPECT_GT(point.u[0], 1.0);
  }
}

TEST(Continuation, TwoFoldsWithinOneLongStepAreBothFound) {
  for (const double s : {1e-1, 1e-2, 1e-3, 1e-4}) {
    ContinuationOptions options = range(-5.0, 5.0);
    options.max_step = 2.0;
    options.max_distance = 1.0;
    const Branch branch = traced(cubic(s), options, 1.5, 3.0);
    ASSERT_EQ(branch.critical_of(CriticalKind::kFold).size(), 2u) << s;
    for (const CriticalPoint& fold : branch.critical_of(CriticalKind::kFold))
      EXPECT_NEAR(std::abs(fold.point.parameter) / (2.0 * std::pow(s, 1.5)), 1.0, 1e-9) << s;
  }
}

TEST(Continuation, AngleClosesAfterATurn) {
  ZeroProblem problem = scalar_problem([](double u, double p) {
    return Scalar{p - 0.5 * std::sin(u), -0.5 * std::cos(u), 1.0};
  });
  problem.wrap = Vector::Constant(1, 2.0 * std::numbers::pi);
  const Branch branch = traced(problem, range(-1.0, 1.0), 0.3, 0.5 * std::sin(0.3));
  ASSERT_TRUE(branch.closed());
  EXPECT_EQ(branch.critical_of(CriticalKind::kFold).size(), 2u);
  EXPECT_NEAR(std::abs(branch.points.back().u[0] - branch.points.front().u[0]),
              2.0 * std::numbers::pi, 1e-7);
}

// (u - sin f p)(u - sin f p - d) = 0: two copies of one curve, d apart. On a bend the prediction
// overshoots towards the outer one.
void expect_no_jump(double frequency, double d, double longest) {
  SCOPED_TRACE(testing::Message() << "frequency " << frequency << ", apart " << d << ", step "
                                  << longest);
  const ZeroProblem problem = scalar_problem([=](double u, double p) {
    const double w = u - std::sin(frequency * p), slope = 2.0 * w - d;
    return Scalar{w * (w - d), slope, -frequency * std::cos(frequency * p) * slope};
  });
  ContinuationOptions options = range(-2.0, 2.0);
  options.max_step = longest;
  options.max_distance = longest;
  const Branch branch = traced(problem, options, 0.0, 0.0);
  EXPECT_EQ(branch.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(branch.ends[1], BranchEnd::kParameterLimit);
  double furthest = 0.0;
  for (const SolutionPoint& point : branch.points)
    furthest = std::max(furthest, std::abs(point.u[0] - std::sin(frequency * point.parameter)));
  EXPECT_LE(furthest, 1e-9 / d);
}

TEST(Continuation, StepsStayOnTheirBranchBesideAParallelOne) {
  for (const double frequency : {1.0, 2.0, 5.0, 10.0})
    for (const double d : {0.3, 0.1, 0.03, 0.01, 0.003})
      for (const double longest : {0.2, 1.0, 4.0}) expect_no_jump(frequency, d, longest);
}

TEST(Continuation, EndsWhereTheEquationsCeaseToExist) {
  ZeroProblem problem = scalar_problem([](double u, double p) {
    return Scalar{u - p * p, 1.0, -2.0 * p};
  });
  const auto everywhere = problem.evaluate;
  problem.evaluate = [everywhere](const Vector& u,
                                  Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double p = parameters[0];
    if (p < -0.5) return {};
    return everywhere(u, parameters);
  };
  const Branch branch = traced(problem, range(-1.0, 1.0), 0.0, 0.0);
  const bool backward = branch.points.front().parameter < 0.0;
  const SolutionPoint& last = backward ? branch.points.front() : branch.points.back();
  EXPECT_EQ(branch.ends[backward ? 0 : 1], BranchEnd::kNotConverged);
  EXPECT_GE(last.parameter, -0.5);
  EXPECT_NEAR(last.parameter, -0.5, 1e-9);
  EXPECT_EQ(branch.ends[backward ? 1 : 0], BranchEnd::kParameterLimit);

  // The limit itself is still reached where the equations exist up to it.
  const Branch up_to = traced(problem, range(-0.5, 1.0), 0.0, 0.0);
  EXPECT_EQ(up_to.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(up_to.ends[1], BranchEnd::kParameterLimit);
  EXPECT_EQ(std::min(up_to.points.front().parameter, up_to.points.back().parameter), -0.5);
}

TEST(Continuation, NotANumberIsNoSolution) {
  const ZeroProblem problem = scalar_problem([](double u, double p) {
    return Scalar{u - std::sqrt(p), 1.0, -0.5 / std::sqrt(p)};
  });
  EXPECT_FALSE(solve_at(problem, range(-1.0, 1.0), Vector::Ones(1), -0.5));
  const Branch branch = traced(problem, range(-1.0, 1.0), 0.7, 0.5);
  for (const SolutionPoint& point : branch.points) {
    EXPECT_GE(point.parameter, 0.0);
    EXPECT_NEAR(point.u[0], std::sqrt(point.parameter), 1e-10);
  }
}

TEST(Continuation, StopsAtItsLimitOfPoints) {
  ContinuationOptions options = range(-2.0, 2.0);
  options.max_points = 5;
  const Branch branch = traced(circle(), options, 1.0, 0.1);
  EXPECT_EQ(branch.ends[0], BranchEnd::kStepLimit);
  EXPECT_EQ(branch.ends[1], BranchEnd::kStepLimit);
  EXPECT_LE(branch.points.size(), 13u);
}

TEST(Continuation, StopsWhenInterrupted) {
  const std::atomic<bool> interrupted{true};
  ContinuationOptions options = range(-2.0, 2.0);
  options.stop.interrupted = &interrupted;
  const Branch branch = traced(circle(), options, 1.0, 0.1);
  EXPECT_EQ(branch.ends[0], BranchEnd::kStopped);
  EXPECT_EQ(branch.points.size(), 1u);
}

TEST(Continuation, SaysThatItsTimeIsOver) {
  ContinuationOptions options = range(-2.0, 2.0);
  options.stop.deadline = std::chrono::steady_clock::now();
  const Branch branch = traced(circle(), options, 1.0, 0.1);
  EXPECT_EQ(branch.ends[0], BranchEnd::kOutOfTime);
  EXPECT_EQ(branch.points.size(), 1u);
}

TEST(Continuation, TangentsAreThoseOfTheCurve) {
  ContinuationOptions options = range(-2.0, 2.0);
  const Branch branch = traced(circle(), options, 1.0, 0.1);
  const double scale = 4.0;  // the parameter is measured in units of its range
  for (const SolutionPoint& point : branch.points) {
    Vector tangent(2);
    tangent << -point.parameter, point.u[0] / scale;
    tangent.normalize();
    EXPECT_NEAR(std::abs(tangent.dot(point.tangent)), 1.0, 1e-9);
    EXPECT_NEAR(point.tangent.norm(), 1.0, 1e-14);
  }
}

TEST(Continuation, SolvesAtAParameterToTheLastBit) {
  const auto point = solve_at(circle(), range(-2.0, 2.0), Vector::Constant(1, 0.9), 0.3);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->parameter, 0.3);
  EXPECT_NEAR(point->u[0], std::sqrt(0.91), 1e-15);
  EXPECT_FALSE(solve_at(circle(), range(-2.0, 2.0), Vector::Constant(1, 0.9), 1.3));
}

// At (0, 1) the circle turns back: no solution at a fixed parameter, but one across the branch.
TEST(Continuation, SolvesAtAFold) {
  const ContinuationOptions options = range(-2.0, 2.0);
  for (const Vector& along : {Vector(), Vector{{1.0, 0.0}}}) {
    const auto point = solve_near(circle(), options, Vector::Constant(1, 1e-3), 1.0, along);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->u.squaredNorm() + point->parameter * point->parameter, 1.0, 1e-13);
    EXPECT_NEAR(point->parameter, 1.0, 1e-5);
    EXPECT_NEAR(std::abs(point->tangent[0]), 1.0, 1e-2);
  }
}

TEST(Continuation, LocatesATestFunction) {
  const ZeroProblem problem = circle();
  const ContinuationOptions options = range(-2.0, 2.0);
  const Branch branch = traced(problem, options, 1.0, 0.0);
  const auto test = [](const SolutionPoint& point) { return point.u[0] - 0.6; };
  int found = 0;
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
    const auto point = locate(problem, options, branch.points[i], branch.points[i + 1], test);
    const bool crosses = test(branch.points[i]) * test(branch.points[i + 1]) < 0.0;
    EXPECT_EQ(point.has_value(), crosses);
    if (!point) continue;
    ++found;
    EXPECT_NEAR(std::abs(point->parameter), 0.8, 1e-12);
  }
  EXPECT_EQ(found, 2);
}

TEST(Continuation, KnowsWhatLiesOnABranch) {
  const ZeroProblem problem = circle();
  const ContinuationOptions options = range(-2.0, 2.0);
  const Branch whole = traced(problem, options, 1.0, 0.1);
  const auto low = solve_at(problem, options, Vector::Constant(1, -0.7), -0.7);
  const auto high = solve_at(problem, options, Vector::Constant(1, 0.3), 0.95);
  ASSERT_TRUE(low && high);
  EXPECT_TRUE(lies_on(problem, options, whole, *low));
  EXPECT_TRUE(lies_on(problem, options, whole, *high));

  // Of two branches, a point lies on its own.
  const ZeroProblem two = scalar_problem([](double u, double p) {
    return Scalar{(u - p) * (u - p - 0.05), 2.0 * (u - p) - 0.05, -2.0 * (u - p) + 0.05};
  });
  const Branch first = traced(two, options, 0.3, 0.3);
  const auto other = solve_at(two, options, Vector::Constant(1, 0.56), 0.5);
  ASSERT_TRUE(other);
  EXPECT_FALSE(lies_on(two, options, first, *other));
}

}  // namespace
}  // namespace graze
