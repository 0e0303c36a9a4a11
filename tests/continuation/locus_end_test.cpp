// How loci start, close and end.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>

#include "plane_maps.hpp"

namespace graze {
namespace {

using support::henon_plane;
using support::labels_of;
using support::only;
using support::plane;
using support::plane_map;
using support::traced;

using Labels = std::vector<std::string>;

// x -> x + p^2 + q^2 - 1 - x^2: folds on the unit circle.
TEST(LocusEnds, ClosedLocusOfFolds) {
  const ZeroProblem problem =
      periodic_points(plane_map([](const auto& x, const auto& p, const auto& q) {
        using S = std::decay_t<decltype(p)>;
        return std::vector<S>{x[0] + p * p + q * q - S(1.0) - x[0] * x[0]};
      }));
  const Locus locus = traced(problem, plane(-2.0, 2.0, -3.0, 3.0),
                             {LocusKind::kFold, Vector{{0.1}}, 0.8, 0.65, {}});
  EXPECT_TRUE(locus.closed());
  EXPECT_TRUE(locus.special.empty());
  for (const LocusPoint& point : locus.points)
    EXPECT_NEAR(std::hypot(point.first, point.second), 1.0, 1e-12);
  // Cut by the limit p = 0.5.
  const Locus half =
      traced(problem, plane(0.5, 2.0, -3.0, 3.0), {LocusKind::kFold, Vector{{0.1}}, 0.8, 0.65, {}});
  for (const LocusEnd end : half.ends) EXPECT_EQ(end, LocusEnd::kFirstLimit);
  for (const LocusPoint& end : {half.points.front(), half.points.back()}) {
    EXPECT_EQ(end.first, 0.5);
    EXPECT_NEAR(std::abs(end.second), std::sqrt(0.75), 1e-12);
  }
}

// x -> S x/2 - x with S = [[1 + p, q], [q, 1 - p]], of eigenvalues 1 +- r: doublings on the unit
// circle, along which the critical vector turns by half a turn and comes back as its opposite.
TEST(LocusEnds, ClosedLocusWhoseVectorComesBackTurnedRound) {
  const ZeroProblem problem =
      periodic_points(plane_map([](const auto& x, const auto& p, const auto& q) {
        using S = std::decay_t<decltype(p)>;
        const S half(0.5), one(1.0);
        return std::vector<S>{half * ((one + p) * x[0] + q * x[1]) - x[0],
                              half * (q * x[0] + (one - p) * x[1]) - x[1]};
      }));
  const Locus locus = traced(problem, plane(-2.0, 2.0, -2.0, 2.0),
                             {LocusKind::kPeriodDoubling, Vector::Zero(2), 0.8, 0.65, {}});
  EXPECT_TRUE(locus.closed());
  EXPECT_TRUE(locus.special.empty());
  EXPECT_GT(locus.points.size(), 50u);
  for (const LocusPoint& point : locus.points)
    EXPECT_NEAR(std::hypot(point.first, point.second), 1.0, 1e-12);
}

// The tori of Henon's 2-cycles (locus_test.cpp) begin at p = 3, where these shrink into the fixed
// point at its R2: there tori of the fixed point run twice cross them at the angle 0, and the
// equations are singular.
TEST(LocusEnds, ToriOfADoubledOrbitBeginAtAResonance) {
  const double r = 0.5 * (7.0 - std::cos(1.0)), half = std::sqrt(4.0 * r - 12.0);
  const double x = (2.0 + half) / (2.0 * r), y = (2.0 - half) / (2.0 * r);
  const auto locus =
      trace_locus(periodic_points(henon_plane(), 2), plane(2.5, 5.0, -2.0, 1.0),
                  {LocusKind::kTorus, Vector{{x, -y, y, -x}}, r, -1.0, std::polar(1.0, 1.0)});
  ASSERT_TRUE(locus);
  for (const LocusEnd end : locus->ends) EXPECT_EQ(end, LocusEnd::kResonance);
  EXPECT_LT(locus->points.size(), 80u);
  for (const LocusPoint& point : locus->points)
    EXPECT_NEAR(point.first, 0.5 * (7.0 - std::cos(point.angle)), 1e-9);
  EXPECT_NEAR(only(*locus, LocusPointKind::kResonance1).first, 3.0, 1e-9);
  EXPECT_NEAR(only(*locus, LocusPointKind::kResonance1).angle, 0.0, 1e-4);
  EXPECT_NEAR(only(*locus, LocusPointKind::kResonance2).first, 4.0, 1e-12);
  EXPECT_EQ(locus->special.size(), 4u);
}

// A locus may be entered where it is special.
TEST(LocusEnds, LociLeadOnFromTheirSpecialPoints) {
  const ZeroProblem henon = periodic_points(henon_plane());
  const LocusOptions options = plane(-2.0, 5.0, -1.5, 0.8);
  const Vector meeting{{1.0, -1.0}}, doubling{{1.0 / 3.0, -1.0 / 3.0}};
  const Locus folds = traced(henon, options, {LocusKind::kFold, meeting, -1.0, -1.0, {}});
  EXPECT_EQ(labels_of(folds), Labels{"R1"});
  const Locus doublings =
      traced(henon, options, {LocusKind::kPeriodDoubling, doubling, 3.0, -1.0, {}});
  EXPECT_EQ(labels_of(doublings), Labels{"R2"});
  for (const LocusStart& start : {LocusStart{LocusKind::kTorus, meeting, -1.0, -1.0, 1.0},
                                  LocusStart{LocusKind::kTorus, doubling, 3.0, -1.0, -1.0}}) {
    const Locus tori = traced(henon, options, start);
    EXPECT_EQ(tori.special.size(), 4u);
    EXPECT_NEAR(only(tori, LocusPointKind::kResonance1).first, -1.0, 1e-12);
    EXPECT_NEAR(only(tori, LocusPointKind::kResonance2).first, 3.0, 1e-12);
  }
  const ZeroProblem cusp =
      periodic_points(plane_map([](const auto& x, const auto& p, const auto& q) {
        using S = std::decay_t<decltype(p)>;
        return std::vector<S>{x[0] + p + q * x[0] - x[0] * x[0] * x[0]};
      }));
  const Locus through =
      traced(cusp, plane(-3.0, 3.0, -1.0, 2.0), {LocusKind::kFold, Vector{{0.0}}, 0.0, 0.0, {}});
  EXPECT_EQ(labels_of(through), Labels{"CP"});
  EXPECT_NEAR(through.points.front().second, 2.0, 1e-12);
  EXPECT_NEAR(through.points.back().second, 2.0, 1e-12);
}

TEST(LocusEnds, AKnownLocusIsRecognised) {
  const ZeroProblem problem = periodic_points(henon_plane());
  const LocusOptions options = plane(-2.0, 5.0, -1.5, 0.8);
  const LocusStart fold{LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}};
  const LocusStart other{LocusKind::kFold, Vector{{4.0, 2.0}}, -0.06, 0.5, {}};
  const LocusStart doubling{LocusKind::kPeriodDoubling, Vector{{0.6, 0.1}}, 0.7, 0.0, {}};
  const Locus folds = traced(problem, options, fold);
  EXPECT_TRUE(find_locus(problem, options, {folds}, fold));
  EXPECT_TRUE(find_locus(problem, options, {folds}, other));
  EXPECT_FALSE(find_locus(problem, options, {folds}, doubling));
  const double c = std::cos(1.2), p = c * c - 2.0 * c, d = std::cos(2.0), r = d * d - 2.0 * d;
  const LocusStart torus{LocusKind::kTorus, Vector{{-c / p, c / p}}, p, -1.0, std::polar(1.0, 1.2)};
  const LocusStart further{LocusKind::kTorus, Vector{{-d / r, d / r}}, r, -1.0,
                           std::polar(1.0, 2.02)};
  const Locus tori = traced(problem, options, torus);
  EXPECT_TRUE(find_locus(problem, options, {tori}, further));
  EXPECT_FALSE(find_locus(problem, options, {tori}, fold));
}

TEST(LocusEnds, StartsThatLeadNowhereAreRefused) {
  const ZeroProblem problem = periodic_points(henon_plane());
  const LocusOptions options = plane(-2.0, 1.0, -1.5, 0.8);
  // Out of the ranges: the fold at q = 0 is at p = -1/4.
  EXPECT_FALSE(trace_locus(problem, plane(0.0, 1.0, -0.1, 0.8),
                           {LocusKind::kFold, Vector{{2.1, 0.1}}, 0.1, 0.0, {}}));
  // Too far away: the doubling at q = 0 is at p = 3/4.
  EXPECT_FALSE(trace_locus(problem, plane(0.0, 5.0, -1.5, 0.8),
                           {LocusKind::kPeriodDoubling, Vector{{0.4, 0.0}}, 3.5, 0.0, {}}));
  // x -> p x/2 with p <= 1 never folds.
  const ZeroProblem steady =
      periodic_points(plane_map([](const auto& x, const auto& p, const auto& q) {
        using S = std::decay_t<decltype(p)>;
        return std::vector<S>{S(0.5) * p * x[0] + S(0.1) * q};
      }));
  EXPECT_FALSE(trace_locus(steady, plane(-1.0, 1.0, -1.0, 1.0),
                           {LocusKind::kFold, Vector{{0.2}}, 0.3, 0.3, {}}));
  // x -> x + q x - x^3 + (p - p): two branches cross at q = 0 for each p, which no fold does.
  const ZeroProblem symmetric =
      periodic_points(plane_map([](const auto& x, const auto& p, const auto& q) {
        using S = std::decay_t<decltype(p)>;
        return std::vector<S>{x[0] + q * x[0] - x[0] * x[0] * x[0] + (p - p)};
      }));
  EXPECT_FALSE(trace_locus(symmetric, plane(-1.0, 1.0, -1.0, 1.0),
                           {LocusKind::kFold, Vector{{0.1}}, 0.3, 0.02, {}}));
  // Cannot be evaluated there.
  ZeroProblem blind = problem;
  blind.evaluate = [](const Vector&, Parameters) { return std::optional<ZeroEvaluation>(); };
  EXPECT_FALSE(trace_locus(blind, options, {LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}}));
}

TEST(LocusEnds, TracesStopWhenAsked) {
  ZeroProblem problem = periodic_points(henon_plane());
  LocusOptions options = plane(-2.0, 1.0, -1.5, 0.8);
  const LocusStart start{LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}};
  std::atomic<bool> interrupted = false;
  options.stop.interrupted = &interrupted;
  int left = 40;
  problem.evaluate = [&, evaluate = problem.evaluate](const Vector& u, Parameters parameters) {
    if (--left == 0) interrupted = true;
    return evaluate(u, parameters);
  };
  const auto locus = trace_locus(problem, options, start);
  ASSERT_TRUE(locus);
  EXPECT_EQ(locus->ends[0], LocusEnd::kStopped);
  EXPECT_EQ(locus->ends[1], LocusEnd::kStopped);
  EXPECT_GE(left, -10);
  interrupted = false;
  options.max_points = 5;
  const auto shortened = trace_locus(problem, options, start);
  ASSERT_TRUE(shortened);
  EXPECT_EQ(shortened->ends[0], LocusEnd::kStepLimit);
  EXPECT_LE(shortened->points.size(), 12u);
}

// Beyond the limits there may be nothing to evaluate.
TEST(LocusEnds, NothingIsAskedFarBeyondTheLimits) {
  ZeroProblem problem = periodic_points(henon_plane());
  problem.evaluate = [evaluate = problem.evaluate](const Vector& u, Parameters parameters) {
    const double p = parameters[0], q = parameters[1];
    if (p < -0.7 - 1e-12 || q > 0.3 + 1e-12) return std::optional<ZeroEvaluation>();
    return evaluate(u, parameters);
  };
  const Locus locus = traced(problem, plane(-0.7, 1.0, -2.0, 0.3),
                             {LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}});
  EXPECT_TRUE((locus.ends == std::array{LocusEnd::kFirstLimit, LocusEnd::kSecondLimit}) ||
              (locus.ends == std::array{LocusEnd::kSecondLimit, LocusEnd::kFirstLimit}));
}

// Fold at x = 2/(1 - q), p = -(1 - q)^2/4.
TEST(LocusEnds, CallersMayEndALocusAndLookForZeros) {
  LocusOptions options = plane(-2.0, 1.0, -1.5, 0.8);
  options.proceed = [](const LocusPoint&, const LocusPoint& here) { return here.first > -0.5; };
  options.tests = [](const LocusPoint& point) {
    return std::optional<Vector>(Vector{{point.u[0] - 4.0, point.first + 0.36}});
  };
  const Locus locus = traced(periodic_points(henon_plane()), options,
                             {LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}});
  const bool first = locus.ends[0] == LocusEnd::kHalted;
  EXPECT_EQ(locus.ends[first ? 0 : 1], LocusEnd::kHalted);
  EXPECT_EQ(locus.ends[first ? 1 : 0], LocusEnd::kSecondLimit);
  EXPECT_LE((first ? locus.points.front() : locus.points.back()).first, -0.5);
  ASSERT_EQ(locus.zeros.size(), 2u);
  EXPECT_EQ(locus.zeros[0].test, 0u);
  EXPECT_NEAR(locus.zeros[0].point.second, 0.5, 1e-12);
  EXPECT_EQ(locus.zeros[1].test, 1u);
  EXPECT_NEAR(locus.zeros[1].point.second, -0.2, 1e-12);
}

}  // namespace
}  // namespace graze
