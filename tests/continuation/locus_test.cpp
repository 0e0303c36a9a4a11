// Loci of maps for which they are known in closed form.
#include "graze/continuation/locus/locus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plane_maps.hpp"

namespace graze {
namespace {

using support::henon_plane;
using support::labels_of;
using support::only;
using support::plane;
using support::traced;

constexpr double kPi = std::numbers::pi;

// Fold at x = 2/(1 - q), p = -(1 - q)^2/4; multipliers 1 and -q, so R1 at q = -1.
TEST(Loci, HenonFoldsLieOnTheirParabola) {
  const ZeroProblem problem = periodic_points(henon_plane());
  for (const LocusOptions& options :
       {plane(-2.0, 1.0, -1.5, 0.8), plane(1.0, -2.0, 0.8, -1.5), plane(-20.0, 20.0, -3.0, 0.9),
        plane(-1.2, -0.01, -5.0, 0.9)}) {
    SCOPED_TRACE(options.second_from);
    const Locus locus =
        traced(problem, options, {LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}});
    for (const LocusPoint& point : locus.points) {
      const double q = point.second;
      EXPECT_NEAR(point.first, -0.25 * (1.0 - q) * (1.0 - q), 1e-12);
      EXPECT_NEAR(point.u[0], 2.0 / (1.0 - q), 1e-10);
      ASSERT_EQ(point.multipliers.size(), 2u);
      EXPECT_EQ(point.multipliers[q < -1.0 ? 1 : 0].value, Complex(1.0));
    }
    EXPECT_EQ(labels_of(locus), std::vector<std::string>{"R1"});
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance1).second, -1.0, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance1).first, -1.0, 1e-12);
  }
}

TEST(Loci, EndOnTheLimitsExactly) {
  const ZeroProblem problem = periodic_points(henon_plane());
  const LocusStart start{LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}};
  const Locus by_second = traced(problem, plane(-2.0, 1.0, -0.7, 0.3), start);
  for (const LocusEnd end : by_second.ends) EXPECT_EQ(end, LocusEnd::kSecondLimit);
  EXPECT_EQ(std::min(by_second.points.front().second, by_second.points.back().second), -0.7);
  EXPECT_EQ(std::max(by_second.points.front().second, by_second.points.back().second), 0.3);
  const Locus by_first = traced(problem, plane(-0.7, -0.1, -7.0, 3.0), start);
  for (const LocusEnd end : by_first.ends) EXPECT_EQ(end, LocusEnd::kFirstLimit);
  for (const LocusPoint& end : {by_first.points.front(), by_first.points.back()}) {
    EXPECT_TRUE(end.first == -0.7 || end.first == -0.1) << end.first;
    EXPECT_NEAR(end.second, 1.0 - 2.0 * std::sqrt(-end.first), 1e-12);
  }
}

// Doubling at p = 3 (1 - q)^2/4; multipliers -1 and q, so R2 at q = -1.
TEST(Loci, HenonDoublingsLieOnTheirParabola) {
  const ZeroProblem problem = periodic_points(henon_plane());
  for (const double max_step : {0.0, 0.1, 0.003}) {
    LocusOptions options = plane(0.0, 5.0, -1.4, 0.7);
    options.max_step = max_step;
    const Locus locus =
        traced(problem, options, {LocusKind::kPeriodDoubling, Vector{{0.6, 0.1}}, 0.7, 0.0, {}});
    for (const LocusPoint& point : locus.points)
      EXPECT_NEAR(point.first, 0.75 * (1.0 - point.second) * (1.0 - point.second), 1e-12);
    EXPECT_EQ(labels_of(locus), std::vector<std::string>{"R2"});
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance2).second, -1.0, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance2).first, 3.0, 1e-12);
  }
}

// On q = -1 the map keeps areas: with x = -cos(angle)/p, p = cos^2 - 2 cos from R1 to R2.
TEST(Loci, HenonToriLieUprightBetweenTheirResonances) {
  const ZeroProblem problem = periodic_points(henon_plane());
  for (const double angle : {0.3, 1.2, 2.5}) {
    SCOPED_TRACE(angle);
    const double c = std::cos(angle), p = c * c - 2.0 * c, x = -c / p;
    const Locus locus =
        traced(problem, plane(-3.0, 5.0, -2.0, 1.0),
               {LocusKind::kTorus, Vector{{x + 0.01, -x}}, p, -1.0, std::polar(1.0, angle + 0.02)});
    for (const LocusPoint& point : locus.points) {
      const double cosine = std::cos(point.angle);
      EXPECT_NEAR(point.second, -1.0, 1e-12);
      EXPECT_NEAR(point.first, cosine * cosine - 2.0 * cosine, 1e-12);
    }
    for (const LocusEnd end : locus.ends) EXPECT_EQ(end, LocusEnd::kResonance);
    EXPECT_EQ(locus.special.size(), 4u);
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance1).first, -1.0, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance4).first, 0.0, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance3).first, 1.25, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kResonance2).first, 3.0, 1e-12);
    EXPECT_EQ(only(locus, LocusPointKind::kResonance2).angle, kPi);
    EXPECT_EQ(only(locus, LocusPointKind::kResonance1).angle, 0.0);
  }
}

// 2-cycles p x^2 - (1 - q) x + ((1 - q)^2 - p)/p = 0: they double at p = (1 - q)^2 + (1 + q)^2/4
// with multipliers -1 and -q^2; on q = -1 their sum is 14 - 4 p.
Vector two_cycle(double p, double q) {
  const double half = std::sqrt(4.0 * p - 3.0 * (1.0 - q) * (1.0 - q));
  const double first = (1.0 - q + half) / (2.0 * p), second = (1.0 - q - half) / (2.0 * p);
  return Vector{{first, q * second, second, q * first}};
}

TEST(Loci, HenonTwoCyclesDouble) {
  const ZeroProblem problem = periodic_points(henon_plane(), 2);
  const Locus locus = traced(problem, plane(0.0, 6.0, -1.3, 0.7),
                             {LocusKind::kPeriodDoubling, two_cycle(1.26, 0.0), 1.26, 0.0, {}});
  for (const LocusPoint& point : locus.points) {
    const double q = point.second;
    EXPECT_NEAR(point.first, (1.0 - q) * (1.0 - q) + 0.25 * (1.0 + q) * (1.0 + q), 1e-12);
  }
  EXPECT_EQ(labels_of(locus), std::vector<std::string>{"R2"});
  EXPECT_NEAR(only(locus, LocusPointKind::kResonance2).first, 4.0, 1e-12);
  EXPECT_NEAR(only(locus, LocusPointKind::kResonance2).second, -1.0, 1e-12);
}

TEST(Loci, HenonTwoCyclesHaveTheirTori) {
  const ZeroProblem problem = periodic_points(henon_plane(), 2);
  const double angle = 1.0, p = 0.5 * (7.0 - std::cos(angle));
  const Locus locus =
      traced(problem, plane(3.1, 5.0, -2.0, 1.0),
             {LocusKind::kTorus, two_cycle(p, -1.0), p, -1.0, std::polar(1.0, angle)});
  for (const LocusPoint& point : locus.points) {
    EXPECT_NEAR(point.second, -1.0, 1e-12);
    EXPECT_NEAR(point.first, 0.5 * (7.0 - std::cos(point.angle)), 1e-11);
  }
  EXPECT_NEAR(only(locus, LocusPointKind::kResonance4).first, 3.5, 1e-12);
  EXPECT_NEAR(only(locus, LocusPointKind::kResonance3).first, 3.75, 1e-12);
  EXPECT_NEAR(only(locus, LocusPointKind::kResonance2).first, 4.0, 1e-12);
}

// At q = 0 the 3-cycles of the quadratic map, born at p = 7/4. On q = -1 the map x'' + x = 1 - p
// x'^2 can be run backwards: 3-cycles (a, b, b) have a + b = 1/p, p b^2 = 1 - 1/p, so are born at p
// = 1 from (1, 0, 0); both multipliers are 1 there.
TEST(Loci, HenonThreeCyclesAreBorn) {
  const ZeroProblem problem = periodic_points(henon_plane(), 3);
  const LocusStart start{
      LocusKind::kFold, Vector{{0.0314, 0.0, 0.9983, 0.0, -0.744, 0.0}}, 1.75, 0.0, {}};
  const auto at = solve_locus(problem, plane(0.0, 3.0, -1.2, 0.4), start);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->second, 0.0);
  EXPECT_NEAR(at->first, 1.75, 1e-12);
  const Locus locus = traced(problem, plane(0.0, 3.0, -1.2, 0.4), start);
  const LocusPoint resonance = only(locus, LocusPointKind::kResonance1);
  EXPECT_NEAR(resonance.second, -1.0, 1e-11);
  EXPECT_NEAR(resonance.first, 1.0, 1e-11);
  EXPECT_NEAR(resonance.u.cwiseAbs().maxCoeff(), 1.0, 1e-10);
}

// x -> x + p + q x - x^3: folds where q = 3 x^2, p = -2 x^3.
TEST(Loci, FoldsMeetInACusp) {
  const ZeroProblem problem =
      periodic_points(support::plane_map([](const auto& x, const auto& p, const auto& q) {
        using S = std::decay_t<decltype(p)>;
        return std::vector<S>{x[0] + p + q * x[0] - x[0] * x[0] * x[0]};
      }));
  for (const double x : {0.4, -0.7, 0.01}) {
    const Locus locus =
        traced(problem, plane(-3.0, 3.0, -1.0, 2.0),
               {LocusKind::kFold, Vector{{x}}, -2.0 * x * x * x, 3.0 * x * x + 0.01, {}});
    for (const LocusPoint& point : locus.points) {
      EXPECT_NEAR(point.first, -2.0 * std::pow(point.u[0], 3), 1e-12);
      EXPECT_NEAR(point.second, 3.0 * std::pow(point.u[0], 2), 1e-12);
      EXPECT_NEAR(27.0 * point.first * point.first, 4.0 * std::pow(point.second, 3), 1e-10);
    }
    EXPECT_EQ(labels_of(locus), std::vector<std::string>{"CP"});
    const LocusPoint cusp = only(locus, LocusPointKind::kCusp);
    EXPECT_NEAR(cusp.u[0], 0.0, 1e-10);
    EXPECT_NEAR(cusp.first, 0.0, 1e-10);
    EXPECT_NEAR(cusp.second, 0.0, 1e-10);
    for (const LocusEnd end : locus.ends) EXPECT_EQ(end, LocusEnd::kSecondLimit);
  }
}

// x -> p x (1 - (1 - q) x - q y), y -> x: at x = 1 - 1/p the multipliers have the product q (p - 1)
// and the sum 1 - (p - 1)(1 - q). With q = 1 it is the delayed logistic map, whose torus at p = 2
// has the angle pi/3 (Kuznetsov, Elements of Applied Bifurcation Theory, section 4.7).
Map delayed_logistic_in_two() {
  return support::plane_map([](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    return std::vector<S>{p * x[0] * (S(1.0) - (S(1.0) - q) * x[0] - q * x[1]), x[0]};
  });
}

TEST(Loci, DelayedLogisticMapHasItsToriAndDoublings) {
  const ZeroProblem problem = periodic_points(delayed_logistic_in_two());
  const LocusOptions options = plane(1.2, 6.0, -0.5, 2.0);
  const LocusStart start{LocusKind::kTorus, Vector{{0.5, 0.5}}, 2.0, 1.0,
                         std::polar(1.0, kPi / 3.0)};
  const Locus tori = traced(problem, options, start);
  for (const LocusPoint& point : tori.points) {
    EXPECT_NEAR(point.second * (point.first - 1.0), 1.0, 1e-11);
    EXPECT_NEAR(point.first, 3.0 - 2.0 * std::cos(point.angle), 1e-11);
  }
  EXPECT_EQ(tori.special.size(), 3u);
  EXPECT_NEAR(only(tori, LocusPointKind::kResonance4).first, 3.0, 1e-12);
  EXPECT_NEAR(only(tori, LocusPointKind::kResonance3).first, 4.0, 1e-12);
  EXPECT_NEAR(only(tori, LocusPointKind::kResonance2).first, 5.0, 1e-12);
  EXPECT_NEAR(only(tori, LocusPointKind::kResonance2).second, 0.25, 1e-12);
  // (p - 1)(1 - 2 q) = 2
  const Locus doublings =
      traced(problem, options, {LocusKind::kPeriodDoubling, Vector{{0.66, 0.66}}, 3.0, 0.0, {}});
  for (const LocusPoint& point : doublings.points)
    EXPECT_NEAR((point.first - 1.0) * (1.0 - 2.0 * point.second), 2.0, 1e-11);
  EXPECT_EQ(labels_of(doublings), std::vector<std::string>{"R2"});
  EXPECT_NEAR(only(doublings, LocusPointKind::kResonance2).first, 5.0, 1e-12);
  EXPECT_NEAR(only(doublings, LocusPointKind::kResonance2).second, 0.25, 1e-12);
}

}  // namespace
}  // namespace graze
