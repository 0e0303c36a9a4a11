// Special points of maps and equations for which they are known in closed form.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "graze/continuation/map.hpp"
#include "graze/continuation/switching.hpp"
#include "known_problems.hpp"

namespace graze {
namespace {

using support::range;
using support::traced;

// x -> p x (1 - x): fixed points 0 and 1 - 1/p cross at p = 1; the latter doubles at p = 3, the
// doubled orbit at 1 + sqrt(6), and that at 3.5440903595519 (May 1976; to 14 digits from the
// polynomial in p(p - 2) of Kotsireas and Karamanos, Int. J. Bifurcation Chaos 14, 2004).
Map logistic() {
  return Map{[](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
    const double p = parameters[0];
    return MapEvaluation{p * x.cwiseProduct((1.0 - x.array()).matrix()),
                         Matrix::Constant(1, 1, p * (1.0 - 2.0 * x[0])),
                         x.cwiseProduct((1.0 - x.array()).matrix())};
  }};
}

// x -> 1 - p x^2 + y, y -> b x: fold at p = -(1 - b)^2/4, doubling at 3 (1 - b)^2/4, next doubling
// at (1 - b)^2 + (1 + b)^2/4 (Henon 1976).
Map henon(double b) {
  return Map{[b](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
    const double p = parameters[0];
    MapEvaluation at{Vector(2), Matrix(2, 2), Vector(2)};
    at.image << 1.0 - p * x[0] * x[0] + x[1], b * x[0];
    at.jacobian << -2.0 * p * x[0], 1.0, b, 0.0;
    at.by_parameters << -x[0] * x[0], 0.0;
    return at;
  }};
}

// Delayed logistic map x -> p x (1 - y), y -> x: torus at p = 2, multipliers exp(+-i pi/3) there
// (Kuznetsov, Elements of Applied Bifurcation Theory, section 4.7).
Map delayed_logistic() {
  return Map{[](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
    const double p = parameters[0];
    MapEvaluation at{Vector(2), Matrix(2, 2), Vector(2)};
    at.image << p * x[0] * (1.0 - x[1]), x[0];
    at.jacobian << p * (1.0 - x[1]), -p * x[0], 1.0, 0.0;
    at.by_parameters << x[0] * (1.0 - x[1]), 0.0;
    return at;
  }};
}

// The doubled orbits that leave the (only) period doubling of a branch.
Branch doubled(const Map& map, int period, const ContinuationOptions& options,
               const Branch& branch) {
  const auto doublings = branch.critical_of(CriticalKind::kPeriodDoubling);
  EXPECT_EQ(doublings.size(), 1u);
  const ZeroProblem problem = periodic_points(map, 2 * period);
  const auto start = other_branch(problem, options, twice_round(doublings.front().point));
  EXPECT_TRUE(start);
  return trace_branch(problem, options, *start, Directions::kForward);
}

TEST(SpecialPoints, LogisticMapDoublesAndDoublesAgain) {
  const ContinuationOptions options = range(2.0, 3.6);
  const Branch one = traced(periodic_points(logistic()), options, Vector::Constant(1, 0.5), 2.0);
  const auto first = one.critical_of(CriticalKind::kPeriodDoubling);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_NEAR(first[0].point.parameter, 3.0, 1e-13);
  EXPECT_NEAR(first[0].multiplier->value.real(), -1.0, 1e-13);
  EXPECT_EQ(one.critical.size(), 1u);
  const Branch two = doubled(logistic(), 1, options, one);
  const auto second = two.critical_of(CriticalKind::kPeriodDoubling);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_NEAR(second[0].point.parameter, 1.0 + std::sqrt(6.0), 1e-12);
  EXPECT_EQ(two.critical.size(), 1u);
  EXPECT_EQ(two.ends[1], BranchEnd::kParameterLimit);
  EXPECT_EQ(two.points.back().parameter, 3.6);
  // x = (p + 1 +- sqrt((p + 1)(p - 3)))/(2 p)
  for (const SolutionPoint& point : two.points) {
    const double p = point.parameter;
    EXPECT_NEAR(point.u.sum(), (p + 1.0) / p, 1e-7) << p;
    EXPECT_NEAR(std::abs(point.u[0] - point.u[1]),
                std::sqrt(std::max((p + 1.0) * (p - 3.0), 0.0)) / p, 1e-6)
        << p;
  }
  const Branch four = doubled(logistic(), 2, options, two);
  const auto third = four.critical_of(CriticalKind::kPeriodDoubling);
  ASSERT_EQ(third.size(), 1u);
  EXPECT_NEAR(third[0].point.parameter, 3.5440903595519, 1e-12);
}

TEST(SpecialPoints, LogisticMapCrossesItsOtherFixedPoint) {
  const ContinuationOptions options = range(0.2, 2.5);
  const ZeroProblem problem = periodic_points(logistic());
  const Branch zero = traced(problem, options, Vector::Constant(1, 0.0), 0.5);
  const auto crossings = zero.critical_of(CriticalKind::kBranchPoint);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_NEAR(crossings[0].point.parameter, 1.0, 1e-10);
  EXPECT_NEAR(crossings[0].multiplier->value.real(), 1.0, 1e-10);
  const auto start = other_branch(problem, options, crossings[0].point);
  ASSERT_TRUE(start);
  const Branch other = trace_branch(problem, options, *start);
  EXPECT_GT(other.points.size(), 10u);
  for (const SolutionPoint& point : other.points)
    EXPECT_NEAR(point.u[0], 1.0 - 1.0 / point.parameter, 1e-9) << point.parameter;
  EXPECT_EQ(other.ends[0], BranchEnd::kParameterLimit);
  EXPECT_EQ(other.ends[1], BranchEnd::kParameterLimit);
}

TEST(SpecialPoints, HenonMapFoldsAndDoubles) {
  for (const double b : {0.3, -0.4, 0.9}) {
    SCOPED_TRACE(b);
    const ContinuationOptions options = range(-1.0, 3.0);
    const double fold = -0.25 * (1.0 - b) * (1.0 - b), first = -3.0 * fold;
    const double second = (1.0 - b) * (1.0 - b) + 0.25 * (1.0 + b) * (1.0 + b);
    // (1 - b - sqrt((1 - b)^2 + 4 p))/(-2 p) at p = 0.1
    Vector x(2);
    x[0] = (-(1.0 - b) + std::sqrt((1.0 - b) * (1.0 - b) + 0.4)) / 0.2;
    x[1] = b * x[0];
    const Branch one = traced(periodic_points(henon(b)), options, x, 0.1);
    const auto folds = one.critical_of(CriticalKind::kFold);
    const auto doublings = one.critical_of(CriticalKind::kPeriodDoubling);
    ASSERT_EQ(folds.size(), 1u);
    ASSERT_EQ(doublings.size(), 1u);
    EXPECT_NEAR(folds[0].point.parameter, fold, 1e-13);
    EXPECT_NEAR(folds[0].multiplier->value.real(), 1.0, 1e-6);
    EXPECT_NEAR(doublings[0].point.parameter, first, 1e-12);
    const Branch two = doubled(henon(b), 1, options, one);
    const auto again = two.critical_of(CriticalKind::kPeriodDoubling);
    ASSERT_EQ(again.size(), 1u);
    EXPECT_NEAR(again[0].point.parameter, second, 1e-12);
  }
}

// With b = -1 the map keeps areas: between its fold and its doubling both multipliers are on the
// circle, and what their moduli pass there is rounding. They meet at -1 and part on the real axis.
TEST(SpecialPoints, AreaPreservingHenonMapFoldsAndDoublesAndHasNoTorus) {
  for (const double max_step : {0.0, 0.37, 0.01, 1e-3}) {
    SCOPED_TRACE(max_step);
    ContinuationOptions options = range(-1.5, 5.0);
    options.max_step = max_step;
    const double p = 0.1, x = (-1.0 + std::sqrt(1.0 + p)) / p;
    const Branch branch = traced(periodic_points(henon(-1.0)), options, Vector{{x, -x}}, p);
    ASSERT_EQ(branch.critical.size(), 2u);
    const auto doublings = branch.critical_of(CriticalKind::kPeriodDoubling);
    ASSERT_EQ(doublings.size(), 1u);
    EXPECT_NEAR(doublings[0].point.parameter, 3.0, 1e-12);
    EXPECT_NEAR(doublings[0].multiplier->value.real(), -1.0, 1e-6);
    EXPECT_NEAR(branch.critical_of(CriticalKind::kFold).at(0).point.parameter, -1.0, 1e-13);
  }
}

// Multipliers that are noise (of a branch that is two in one) end neither the search nor the
// patience of whoever asked for an end.
TEST(SpecialPoints, SearchThroughNoiseIsBounded) {
  long long asked = 0, allowed = std::numeric_limits<long long>::max();
  std::atomic<bool> interrupted = false;
  ZeroProblem problem = support::straight_line();
  problem.multipliers = [&](const Vector&, Parameters parameters, ErrorBounds) {
    const double p = parameters[0];
    interrupted = ++asked >= allowed;
    const double noise = std::sin(1e15 * p) * 4.0;
    return std::vector<Eigenvalue>{{Complex(noise, 0.0), 1e-12}};
  };
  ContinuationOptions options = range(0.0, 1.0);
  options.max_step = 0.25;
  options.stop.interrupted = &interrupted;
  const auto start = solve_at(problem, options, Vector::Zero(1), 0.0);
  ASSERT_TRUE(start);
  const Branch whole = trace_branch(problem, options, *start);
  EXPECT_EQ(whole.ends[1], BranchEnd::kParameterLimit);
  // A thousand divisions a step, and the location of a crossing (two bits an evaluation) in each.
  const auto steps = static_cast<long long>(whole.points.size());
  EXPECT_LT(asked, steps * 1000 * 60);
  allowed = 500;
  asked = 0;
  trace_branch(problem, options, *start);
  EXPECT_LT(asked, allowed + 200 + 60 * steps) << "the location at hand, and one a step";
}

// Two multipliers enter the circle within one step, between whose ends none can be computed.
TEST(SpecialPoints, WhatCannotBeComputedIsNotLookedInto) {
  ZeroProblem problem = support::straight_line();
  problem.multipliers = [&](const Vector&, Parameters parameters, ErrorBounds errors) {
    const double p = parameters[0];
    if (errors == ErrorBounds::kLeftOut) return std::vector<Eigenvalue>();
    return std::vector<Eigenvalue>{{Complex(-1.5 + p, 0.0), 1e-15},
                                   {Complex(1.5001 - p, 0.0), 1e-15}};
  };
  ContinuationOptions options = range(0.0, 1.0);
  options.max_step = 0.25;
  const Branch branch = traced(problem, options, 0.0, 0.0);
  EXPECT_EQ(branch.ends[1], BranchEnd::kParameterLimit);
  EXPECT_TRUE(branch.critical.empty());
}

TEST(SpecialPoints, DelayedLogisticMapHasItsTorus) {
  const ContinuationOptions options = range(1.2, 2.4);
  const Branch branch =
      traced(periodic_points(delayed_logistic()), options, Vector::Constant(2, 0.3), 1.5);
  const auto tori = branch.critical_of(CriticalKind::kTorus);
  ASSERT_EQ(tori.size(), 1u);
  EXPECT_NEAR(tori[0].point.parameter, 2.0, 1e-12);
  EXPECT_NEAR(std::arg(tori[0].multiplier->value), std::numbers::pi / 3.0, 1e-12);
  EXPECT_EQ(branch.critical.size(), 1u);
}

// Two scalar maps side by side whose multipliers pass -1 within `apart` of each other: both are
// found however long the steps, also when one comes in as the other goes out.
TEST(SpecialPoints, DoublingsSideBySideAreBothFound) {
  for (const double apart : {1e-1, 1e-3, 3e-5, 1e-8})
    for (const double second_slope : {1.0, -1.0}) {
      SCOPED_TRACE(testing::Message() << apart << " " << second_slope);
      const Map map{[=](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
        const double p = parameters[0];
        const double first = -1.0 - p, second = -1.0 - second_slope * (p - apart);
        MapEvaluation at{Vector(2), Matrix::Zero(2, 2), Vector(2)};
        at.image << first * x[0], second * x[1];
        at.jacobian.diagonal() << first, second;
        at.by_parameters << -x[0], -second_slope * x[1];
        return at;
      }};
      const Branch branch = traced(periodic_points(map), range(-0.5, 0.53), Vector::Zero(2), 0.3);
      const auto doublings = branch.critical_of(CriticalKind::kPeriodDoubling);
      ASSERT_EQ(doublings.size(), 2u);
      const double low = std::min(doublings[0].point.parameter, doublings[1].point.parameter);
      const double high = std::max(doublings[0].point.parameter, doublings[1].point.parameter);
      EXPECT_NEAR(low, 0.0, 1e-13);
      EXPECT_NEAR(high, apart, 1e-13);
    }
}

// u (u^2 - p) = 0 with u shifted by s p: a pitchfork whose both branches bend.
TEST(SpecialPoints, PitchforkOnACurvedBranch) {
  ZeroProblem problem;
  problem.evaluate = [](const Vector& x, Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double p = parameters[0];
    const double v = x[0] - std::sin(p), q = p - 0.3;
    return ZeroEvaluation{Vector::Constant(1, v * (v * v - q)),
                          Matrix::Constant(1, 1, 3.0 * v * v - q),
                          Vector::Constant(1, -std::cos(p) * (3.0 * v * v - q) - v)};
  };
  const ContinuationOptions options = range(-1.0, 1.0);
  const Branch branch = traced(problem, options, Vector::Constant(1, std::sin(-0.5)), -0.5);
  const auto crossings = branch.critical_of(CriticalKind::kBranchPoint);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(branch.critical.size(), 1u);
  EXPECT_NEAR(crossings[0].point.parameter, 0.3, 1e-10);
  const auto start = other_branch(problem, options, crossings[0].point);
  ASSERT_TRUE(start);
  const Branch other = trace_branch(problem, options, *start);
  for (const SolutionPoint& point : other.points) {
    const double v = point.u[0] - std::sin(point.parameter);
    EXPECT_NEAR(v * v, point.parameter - 0.3, 1e-9);
  }
  EXPECT_EQ(other.points.front().parameter, 1.0);
  EXPECT_EQ(other.points.back().parameter, 1.0);
  // Met from the side, where its parameter turns back; the fold is not named apart.
  const Branch again = trace_branch(problem, options, other.points[other.points.size() / 4]);
  ASSERT_EQ(again.critical.size(), 1u);
  EXPECT_EQ(again.critical[0].kind, CriticalKind::kBranchPoint);
  EXPECT_NEAR(again.critical[0].point.parameter, 0.3, 1e-11);
}

// Orbits of period 2 pass through those of period 1 where these double: a branch point met from
// the side of the pitchfork, where the parameter turns back, and each point next to it is badly
// determined along the branch that crosses.
TEST(SpecialPoints, PitchforksAreLocatedFromTheirOwnSide) {
  const ContinuationOptions options = range(-1.0, 3.5);
  const auto expect_crossing = [&](const Map& map, const Vector& u, double p, double crossing) {
    const Branch branch = traced(periodic_points(map, 2), options, u, p);
    const auto found = branch.critical_of(CriticalKind::kBranchPoint);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].point.parameter, crossing, 1e-13);
    EXPECT_LE(found[0].point.residual, 1e-14);
    const Eigen::Index n = u.size() / 2;
    EXPECT_LE((found[0].point.u.head(n) - found[0].point.u.tail(n)).norm(), 1e-12);
  };
  // x = (p + 1 +- sqrt((p + 1)(p - 3)))/(2 p)
  const double p = 3.3, root = std::sqrt((p + 1.0) * (p - 3.0));
  Vector u(2);
  u << (p + 1.0 + root) / (2.0 * p), (p + 1.0 - root) / (2.0 * p);
  expect_crossing(logistic(), u, p, 3.0);
  for (const double b : {0.3, -0.4, 0.9}) {
    SCOPED_TRACE(b);
    // p x^2 - (1 - b) x + ((1 - b)^2 - p)/p = 0
    const double q = 0.75 * (1.0 - b) * (1.0 - b) + 0.1;
    const double half = std::sqrt(4.0 * q - 3.0 * (1.0 - b) * (1.0 - b));
    const double first = (1.0 - b + half) / (2.0 * q), second = (1.0 - b - half) / (2.0 * q);
    Vector x(4);
    x << first, b * second, second, b * first;
    expect_crossing(henon(b), x, q, 0.75 * (1.0 - b) * (1.0 - b));
  }
}

}  // namespace
}  // namespace graze
