// Branches that start on a branch point and come back to it: closed, once round, nothing twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "graze/continuation/branch.hpp"
#include "graze/continuation/switching.hpp"

namespace graze {
namespace {

// Every equation times a factor of its own: the same solutions.
ZeroProblem times(const ZeroProblem& problem, const Vector& factors) {
  ZeroProblem scaled = problem;
  scaled.evaluate = [=](const Vector& u, Parameters p) -> std::optional<ZeroEvaluation> {
    auto at = problem.evaluate(u, p);
    if (!at) return {};
    at->residual = factors.asDiagonal() * at->residual;
    at->jacobian = factors.asDiagonal() * at->jacobian;
    at->by_parameters = factors.asDiagonal() * at->by_parameters;
    return at;
  };
  return scaled;
}

// x (x^2 + a p^2 - 1 + c x^2 p) = 0, y = x + p. Off x = 0 lies the oval x^2 (1 + c p) = 1 - a p^2,
// which meets x = 0 at p = +-1/sqrt(a), where it stands upright, and turns back nowhere else.
ZeroProblem oval(double a, double c) {
  ZeroProblem problem;
  problem.evaluate = [=](const Vector& u, Parameters q) -> std::optional<ZeroEvaluation> {
    const double x = u[0], p = q[0], r = x * x + a * p * p - 1.0 + c * x * x * p;
    return ZeroEvaluation{Vector{{x * r, u[1] - x - p}},
                          Matrix{{r + x * (2.0 * x + 2.0 * c * x * p), 0.0}, {-1.0, 1.0}},
                          Vector{{x * (2.0 * a * p + c * x * x), -1.0}}};
  };
  return problem;
}

int sign_changes(const Branch& branch, const std::function<double(const SolutionPoint&)>& of) {
  int changes = 0;
  double last = 0.0;
  for (const SolutionPoint& point : branch.points) {
    const double value = point.orientation == 0 ? 0.0 : of(point);
    if (value * last < 0.0) ++changes;
    if (value != 0.0) last = value;
  }
  return changes;
}

TEST(ClosedBranches, GoOnceRoundFromABranchPoint) {
  for (const double scale : {1.0, 1e12, 1e-12})
    for (const double a : {1.0, 0.7, 0.3, 2.0, 3.0})
      for (const double c : {0.0, 0.1, 0.37, 0.5}) {
        SCOPED_TRACE(testing::Message() << scale << " " << a << " " << c);
        const ZeroProblem problem = times(oval(a, c), Vector{{scale, std::sqrt(scale)}});
        const ContinuationOptions options{.from = -5.0, .to = 5.0};
        const auto start = solve_at(problem, options, Vector{{0.0, -3.0}}, -3.0);
        ASSERT_TRUE(start);
        const Branch straight = trace_branch(problem, options, *start);
        const auto crossings = straight.critical_of(CriticalKind::kBranchPoint);
        ASSERT_EQ(crossings.size(), 2u);
        for (const CriticalPoint& crossing : crossings) {
          EXPECT_NEAR(std::abs(crossing.point.parameter), 1.0 / std::sqrt(a), 1e-9);
          EXPECT_TRUE(crossing.point.bracket->converged);
          const auto other = other_branch(problem, options, crossing.point);
          ASSERT_TRUE(other);
          Branch round = trace_branch(problem, options, *other);
          EXPECT_TRUE(round.closed());
          EXPECT_EQ(round.ends[0], BranchEnd::kClosed);
          // Across the branch point opposite; the start itself is at the ends.
          EXPECT_EQ(sign_changes(round, [](const SolutionPoint& at) { return at.u[0]; }), 1);
          ASSERT_EQ(round.critical.size(), 1u);
          EXPECT_EQ(round.critical[0].kind, CriticalKind::kBranchPoint);
          EXPECT_NEAR(round.critical[0].point.parameter, -crossing.point.parameter, 1e-9);
          list_crossing(round);
          ASSERT_EQ(round.critical.size(), 2u);
          EXPECT_EQ(round.critical[0].point.parameter, crossing.point.parameter);
        }
      }
}

// Two cells of an enzyme, s' = p - s1 + (s2 - s1) - 100 s/(1 + s + s^2): AUTO's demo enz. On the
// branch of equal cells lie BP at p = 34.2229 and 22.1816, joined by a closed one of cells that
// differ (E. Doedel et al., AUTO-07p). That is its own mirror image.
ZeroProblem enzyme() {
  const auto rate = [](double s) { return s / (1.0 + s + s * s); };
  const auto slope = [](double s) {
    const double d = 1.0 + s + s * s;
    return (1.0 - s * s) / (d * d);
  };
  ZeroProblem problem;
  problem.evaluate = [=](const Vector& u, Parameters p) -> std::optional<ZeroEvaluation> {
    return ZeroEvaluation{
        Vector{{p[0] - 2.0 * u[0] + u[1] - 100.0 * rate(u[0]),
                p[0] - 2.0 * u[1] + u[0] - 100.0 * rate(u[1])}},
        Matrix{{-2.0 - 100.0 * slope(u[0]), 1.0}, {1.0, -2.0 - 100.0 * slope(u[1])}},
        Vector{{1.0, 1.0}}};
  };
  return problem;
}

TEST(ClosedBranches, TellTheSpecialPointsOfTheEnzymeOnce) {
  for (const Vector& factors : {Vector{{1.0, 1.0}}, Vector{{1e9, 1e-3}}}) {
    const ZeroProblem problem = times(enzyme(), factors);
    const ContinuationOptions options{.from = 0.0, .to = 60.0};
    const auto start = solve_at(problem, options, Vector{{0.0, 0.0}}, 0.0);
    ASSERT_TRUE(start);
    const auto crossings =
        trace_branch(problem, options, *start).critical_of(CriticalKind::kBranchPoint);
    ASSERT_EQ(crossings.size(), 2u);
    EXPECT_NEAR(crossings[0].point.parameter, 34.2229, 1e-4);
    EXPECT_NEAR(crossings[1].point.parameter, 22.1816, 1e-4);
    for (const CriticalPoint& crossing : crossings) {
      const auto other = other_branch(problem, options, crossing.point);
      ASSERT_TRUE(other);
      Branch round = trace_branch(problem, options, *other);
      EXPECT_TRUE(round.closed());
      EXPECT_LT(round.evaluations, 10000);
      list_crossing(round);
      EXPECT_EQ(round.critical_of(CriticalKind::kBranchPoint).size(), 2u);
      const auto folds = round.critical_of(CriticalKind::kFold);
      EXPECT_EQ(folds.size() % 2, 0u);
      for (std::size_t i = 0; i < folds.size(); ++i) {
        const SolutionPoint& fold = folds[i].point;
        int alike = 0, mirrored = 0;
        for (const CriticalPoint& one : folds) {
          alike += (one.point.u - fold.u).norm() < 1e-4;
          mirrored += (one.point.u.reverse() - fold.u).norm() < 1e-4;
        }
        EXPECT_EQ(alike, 1) << fold.parameter;
        EXPECT_EQ(mirrored, 1) << fold.parameter;
        EXPECT_GT((fold.u - crossing.point.u).norm(), 1e-4);
      }
    }
  }
}

// Gerono's lemniscate x^2 = y^2 (1 - y^2), turned. It
// crosses itself where it starts: round it goes through both loops.
TEST(ClosedBranches, ThatCrossThemselvesGoThroughBothLoops) {
  for (const double turn : {0.2, 0.7, 1.2}) {
    ZeroProblem problem;
    const double c = std::cos(turn), s = std::sin(turn);
    problem.evaluate = [=](const Vector& u, Parameters p) -> std::optional<ZeroEvaluation> {
      const double x = c * u[0] - s * p[0], y = s * u[0] + c * p[0];
      const double by_x = 2.0 * x, by_y = 4.0 * y * y * y - 2.0 * y;
      return ZeroEvaluation{Vector{{x * x - y * y * (1.0 - y * y)}}, Matrix{{by_x * c + by_y * s}},
                            Vector{{-by_x * s + by_y * c}}};
    };
    const ContinuationOptions options{.from = -3.0, .to = 3.0};
    SolutionPoint node;
    node.u = Vector{{0.0}};
    // Along x = y and x = -y.
    for (const double side : {1.0, -1.0}) {
      node.tangent = Vector{{c + side * s, (c * side - s) / 6.0}}.normalized();
      const Branch branch = trace_branch(problem, options, node);
      EXPECT_TRUE(branch.closed());
      double lowest = 0.0, highest = 0.0;
      for (const SolutionPoint& at : branch.points) {
        const double y = s * at.u[0] + c * at.parameter;
        lowest = std::min(lowest, y);
        highest = std::max(highest, y);
      }
      EXPECT_GT(highest, 0.9);
      EXPECT_LT(lowest, -0.9);
      // The middle of the eight, passed the other way.
      EXPECT_EQ(branch.critical_of(CriticalKind::kBranchPoint).size(), 1u);
      EXPECT_EQ(
          sign_changes(branch,
                       [&](const SolutionPoint& at) { return s * at.u[0] + c * at.parameter; }),
          1);
    }
  }
}

// Large numbers leave large residuals, however near a solution is.
TEST(Branches, DependNotOnTheSizeOfTheEquations) {
  // u^3 - 3e8 u = 1e12 p: folds at u = -+1e4, p = +-2.
  ZeroProblem cubic;
  cubic.evaluate = [](const Vector& u, Parameters p) -> std::optional<ZeroEvaluation> {
    return ZeroEvaluation{Vector{{u[0] * u[0] * u[0] - 3e8 * u[0] - 1e12 * p[0]}},
                          Matrix{{3.0 * u[0] * u[0] - 3e8}}, Vector{{-1e12}}};
  };
  const ContinuationOptions options{.from = -5.0, .to = 5.0};
  const auto start = solve_at(cubic, options, Vector{{2.2e4}}, 4.0);
  ASSERT_TRUE(start);
  const Branch branch = trace_branch(cubic, options, *start);
  EXPECT_EQ(branch.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(branch.ends[1], BranchEnd::kParameterLimit);
  const auto folds = branch.critical_of(CriticalKind::kFold);
  ASSERT_EQ(folds.size(), 2u);
  for (const CriticalPoint& fold : folds) {
    EXPECT_NEAR(std::abs(fold.point.parameter), 2.0, 1e-9);
    EXPECT_NEAR(fold.point.u[0], -1e4 * std::copysign(1.0, fold.point.parameter), 1e-2);
  }

  std::vector<Branch> same;
  for (const double scale : {1.0, 1e12, 1e-12}) {
    const ZeroProblem problem = times(oval(1.0, 0.37), Vector{{scale, 1.0}});
    const ContinuationOptions range{.from = -2.0, .to = 2.0};
    const auto there = solve_at(problem, range, Vector{{1.1, 1.0}}, 0.1);
    ASSERT_TRUE(there);
    same.push_back(trace_branch(problem, range, *there));
  }
  for (const Branch& other : same) {
    ASSERT_EQ(other.points.size(), same.front().points.size());
    EXPECT_EQ(other.critical.size(), same.front().critical.size());
    EXPECT_LT(other.evaluations, 2 * same.front().evaluations);
    for (std::size_t i = 0; i < other.points.size(); ++i)
      EXPECT_NEAR(other.points[i].u[0], same.front().points[i].u[0], 1e-9);
  }
}

TEST(Branches, TracedForwardsAloneBeginAtTheirStart) {
  ZeroProblem line;
  line.evaluate = [](const Vector& u, Parameters p) -> std::optional<ZeroEvaluation> {
    return ZeroEvaluation{Vector{{u[0] - p[0]}}, Matrix{{1.0}}, Vector{{-1.0}}};
  };
  const ContinuationOptions options{.from = 0.0, .to = 1.0};
  const Branch branch = trace_branch(line, options, *solve_at(line, options, Vector{{0.5}}, 0.5),
                                     Directions::kForward);
  EXPECT_EQ(branch.ends[0], BranchEnd::kStart);
  EXPECT_EQ(branch.ends[1], BranchEnd::kParameterLimit);
}

}  // namespace
}  // namespace graze
