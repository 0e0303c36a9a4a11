// Special points of loci, of maps side by side that have them in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

// x -> x + p + c q^2 - x^2 folds at x = 0, p = -c q^2, multiplier 1 - 2 x; beside it y -> -(1 + q +
// x) y, and a plane turned by an angle and stretched by 1 + q + x. The latter two double and turn
// into tori where x = -q, p = (1 - c) q^2: all meet at p = q = 0.
constexpr double kCurving = 0.3;

Map fold_and_doubling() {
  return plane_map([](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    return std::vector<S>{x[0] + p + S(kCurving) * q * q - x[0] * x[0],
                          S(-1.0) * (S(1.0) + q + x[0]) * x[1] + x[1] * x[1] * x[1]};
  });
}

Map fold_and_torus(double angle) {
  return plane_map([angle](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    const S stretch = S(1.0) + q + x[0], c(std::cos(angle)), s(std::sin(angle));
    return std::vector<S>{x[0] + p + S(kCurving) * q * q - x[0] * x[0],
                          stretch * (c * x[1] - s * x[2]), stretch * (s * x[1] + c * x[2])};
  });
}

TEST(LocusPoints, FoldsAndDoublingsTouch) {
  const ZeroProblem problem = periodic_points(fold_and_doubling());
  const LocusOptions options = plane(-1.0, 1.0, -0.5, 0.6);
  const Locus folds =
      traced(problem, options, {LocusKind::kFold, Vector{{0.01, 0.0}}, -0.03, 0.3, {}});
  const Locus doublings =
      traced(problem, options, {LocusKind::kPeriodDoubling, Vector{{-0.3, 0.0}}, 0.06, 0.3, {}});
  for (const LocusPoint& point : folds.points)
    EXPECT_NEAR(point.first, -kCurving * point.second * point.second, 1e-12);
  for (const LocusPoint& point : doublings.points)
    EXPECT_NEAR(point.first, (1.0 - kCurving) * point.second * point.second, 1e-12);
  for (const Locus& locus : {folds, doublings}) {
    EXPECT_EQ(labels_of(locus), Labels{"LPPD"});
    EXPECT_NEAR(only(locus, LocusPointKind::kFoldDoubling).first, 0.0, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kFoldDoubling).second, 0.0, 1e-12);
  }
}

TEST(LocusPoints, FoldsAndToriTouch) {
  const double angle = 1.9;
  const ZeroProblem problem = periodic_points(fold_and_torus(angle));
  const LocusOptions options = plane(-1.0, 1.0, -0.5, 0.6);
  const Locus folds =
      traced(problem, options, {LocusKind::kFold, Vector{{0.01, 0.0, 0.0}}, -0.03, 0.3, {}});
  const Locus tori =
      traced(problem, options,
             {LocusKind::kTorus, Vector{{-0.3, 0.0, 0.0}}, 0.06, 0.3, std::polar(1.0, -angle)});
  for (const LocusPoint& point : tori.points) {
    EXPECT_NEAR(point.first, (1.0 - kCurving) * point.second * point.second, 1e-12);
    EXPECT_NEAR(point.angle, angle, 1e-12);
  }
  for (const Locus& locus : {folds, tori}) {
    EXPECT_EQ(labels_of(locus), Labels{"LPNS"});
    EXPECT_NEAR(only(locus, LocusPointKind::kFoldTorus).first, 0.0, 1e-12);
    EXPECT_NEAR(only(locus, LocusPointKind::kFoldTorus).second, 0.0, 1e-12);
  }
}

// Fixed point 0 with the multipliers -(1 + q - p^2), (1 + p + q^2/2) e^{+-i (1.2 + p)} and
// (1.1 + p - q) e^{+-2 i}: doublings q = p^2, tori p = -q^2/2 and p = q - 0.1.
Map doubling_and_tori() {
  return plane_map([](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    using std::cos, std::sin;
    const S r = S(1.0) + p + S(0.5) * q * q, a = S(1.2) + p, t = S(1.1) + p - q;
    const S c(std::cos(2.0)), s(std::sin(2.0));
    return std::vector<S>{S(-1.0) * (S(1.0) + q - p * p) * x[0],
                          r * (cos(a) * x[1] - sin(a) * x[2]), r * (sin(a) * x[1] + cos(a) * x[2]),
                          t * (c * x[3] - s * x[4]), t * (s * x[3] + c * x[4])};
  });
}

TEST(LocusPoints, DoublingsAndToriMeet) {
  const ZeroProblem problem = periodic_points(doubling_and_tori());
  const LocusOptions options = plane(-0.7, 0.8, -0.75, 0.9);
  const Vector origin = Vector::Zero(5);
  const Locus doublings =
      traced(problem, options, {LocusKind::kPeriodDoubling, origin, 0.5, 0.26, {}});
  for (const LocusPoint& point : doublings.points)
    EXPECT_NEAR(point.second, point.first * point.first, 1e-12);
  EXPECT_EQ(labels_of(doublings), (Labels{"PDNS", "PDNS"}));
  const Locus first =
      traced(problem, options, {LocusKind::kTorus, origin, -0.08, 0.4, std::polar(1.0, 1.12)});
  for (const LocusPoint& point : first.points) {
    EXPECT_NEAR(point.first, -0.5 * point.second * point.second, 1e-12);
    EXPECT_NEAR(point.angle, 1.2 + point.first, 1e-12);
  }
  const Locus second =
      traced(problem, options, {LocusKind::kTorus, origin, 0.3, 0.41, std::polar(1.0, 2.0)});
  for (const LocusPoint& point : second.points) EXPECT_NEAR(point.first, point.second - 0.1, 1e-12);
  // p = p^2 - 0.1, and q^2/2 + q = 0.1
  const double p = 0.5 * (1.0 - std::sqrt(1.4)), q = std::sqrt(1.2) - 1.0;
  const auto expect_at = [](const LocusPoint& point, double at_p, double at_q) {
    EXPECT_NEAR(point.first, at_p, 1e-12);
    EXPECT_NEAR(point.second, at_q, 1e-12);
  };
  const bool rising = doublings.points.front().first < doublings.points.back().first;
  const auto both = doublings.special_of(LocusPointKind::kDoublingTorus);
  ASSERT_EQ(both.size(), 2u);
  expect_at(both[rising ? 1 : 0].point, 0.0, 0.0);
  expect_at(both[rising ? 0 : 1].point, p, p * p);
  EXPECT_EQ(first.special.size(), 2u);
  expect_at(only(first, LocusPointKind::kDoublingTorus), 0.0, 0.0);
  expect_at(only(first, LocusPointKind::kTwoTori), q - 0.1, q);
  EXPECT_EQ(second.special.size(), 2u);
  expect_at(only(second, LocusPointKind::kDoublingTorus), p, p * p);
  expect_at(only(second, LocusPointKind::kTwoTori), q - 0.1, q);
}

// Henon's map with h(x') = h(f(x)) to be solved, h monotonic: the orbits and multipliers are the
// same, but the closing depends on the orbit.
TEST(LocusPoints, ClosingMayDependOnTheOrbit) {
  const auto phi = [](const auto& u, const auto& c, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    const auto h = [&](const S& x) { return x + (S(0.3) + S(0.1) * q) * x * x * x; };
    std::vector<S> value;
    for (std::size_t i = 0; i < u.size(); i += 2) {
      const bool last = i + 2 == u.size();
      const S& x = last ? c[0] : u[i + 2];
      const S& y = last ? c[1] : u[i + 3];
      value.push_back(h(S(1.0) - p * u[i] * u[i] + u[i + 1]) - h(x));
      value.push_back(h(q * u[i]) - h(y));
    }
    return value;
  };
  const ZeroProblem problem = support::plane_problem(phi);
  const LocusOptions options = plane(-3.0, 5.0, -1.7, 0.6);
  const Locus folds =
      traced(problem, options, {LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0, {}});
  for (const LocusPoint& point : folds.points)
    EXPECT_NEAR(point.first, -0.25 * std::pow(1.0 - point.second, 2), 1e-12);
  EXPECT_NEAR(only(folds, LocusPointKind::kResonance1).first, -1.0, 1e-12);
  const Locus doublings =
      traced(problem, options, {LocusKind::kPeriodDoubling, Vector{{0.6, 0.1}}, 0.7, 0.0, {}});
  for (const LocusPoint& point : doublings.points)
    EXPECT_NEAR(point.first, 0.75 * std::pow(1.0 - point.second, 2), 1e-12);
  EXPECT_NEAR(only(doublings, LocusPointKind::kResonance2).first, 3.0, 1e-12);
  const double c = std::cos(1.2), p = c * c - 2.0 * c;
  const Locus tori =
      traced(problem, options,
             {LocusKind::kTorus, Vector{{-c / p, c / p}}, p, -1.0, std::polar(1.0, 1.22)});
  for (const LocusPoint& point : tori.points) {
    EXPECT_NEAR(point.second, -1.0, 1e-12);
    EXPECT_NEAR(point.first, std::pow(std::cos(point.angle) - 1.0, 2) - 1.0, 1e-12);
  }
  for (const LocusEnd end : tori.ends) EXPECT_EQ(end, LocusEnd::kResonance);
  // 2-cycles, see locus_test.cpp.
  const double r = 0.5 * (7.0 - std::cos(1.0)), half = std::sqrt(4.0 * r - 12.0);
  const double x = (2.0 + half) / (2.0 * r), y = (2.0 - half) / (2.0 * r);
  const Locus cycles =
      traced(problem, plane(3.1, 5.0, -2.0, 1.0),
             {LocusKind::kTorus, Vector{{x, -y, y, -x}}, r, -1.0, std::polar(1.0, 1.0)});
  for (const LocusPoint& point : cycles.points) {
    EXPECT_NEAR(point.second, -1.0, 1e-12);
    EXPECT_NEAR(point.first, 0.5 * (7.0 - std::cos(point.angle)), 1e-11);
  }
}

// Fixed point 0 with the multipliers -(1 + q - sin(2 p)/2), (1 + p - q^2) e^{+-i (1.5 + p)}, 0.6
// and -0.3, in a basis that turns through several turns along the loci: the vectors that are
// critical at one end are at right angles to those further on, again and again.
TEST(LocusPoints, CriticalVectorsMayTurnAsTheyLike) {
  const auto map = plane_map([](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    using std::cos, std::sin;
    std::vector<S> y(x.begin(), x.end());
    const std::vector<S> angles{S(9.0) * p + S(5.0) * q, S(7.0) * q - S(4.0) * p, S(8.0) * p,
                                S(6.0) * q + S(3.0) * p};
    const auto turn = [&y](std::size_t i, const S& angle) {
      const S c = cos(angle), s = sin(angle), a = y[i], b = y[i + 1];
      y[i] = c * a - s * b;
      y[i + 1] = s * a + c * b;
    };
    for (std::size_t i = 0; i < 4; ++i) turn(i, S(-1.0) * angles[i]);
    const S r = S(1.0) + p - q * q, c = cos(S(1.5) + p), s = sin(S(1.5) + p);
    y = {S(-1.0) * (S(1.0) + q - S(0.5) * sin(S(2.0) * p)) * y[0], r * (c * y[1] - s * y[2]),
         r * (s * y[1] + c * y[2]), S(0.6) * y[3], S(-0.3) * y[4]};
    for (std::size_t i = 4; i-- > 0;) turn(i, angles[i]);
    return y;
  });
  const ZeroProblem problem = periodic_points(map);
  const Vector origin = Vector::Zero(5);
  const Locus doublings = traced(problem, plane(-3.0, 3.0, -1.0, 1.0),
                                 {LocusKind::kPeriodDoubling, origin, 0.3, 0.29, {}});
  for (const LocusEnd end : doublings.ends) EXPECT_EQ(end, LocusEnd::kFirstLimit);
  for (const LocusPoint& point : doublings.points)
    EXPECT_NEAR(point.second, 0.5 * std::sin(2.0 * point.first), 1e-12);
  // 1 + p - q^2 is 1 at p = 0, and -1 where p + 2 = sin(2 p)^2/4.
  EXPECT_EQ(labels_of(doublings), (Labels{"PDNS", "PDNS"}));
  for (const LocusSpecialPoint& special : doublings.special) {
    const double p = special.point.first, sine = std::sin(2.0 * p);
    EXPECT_NEAR(p > -1.0 ? p : p + 2.0 - 0.25 * sine * sine, 0.0, 1e-12);
  }
  const Locus tori = traced(problem, plane(-3.0, 3.0, -1.0, 1.0),
                            {LocusKind::kTorus, origin, 0.5, 0.7, std::polar(1.0, 2.0)});
  for (const LocusEnd end : tori.ends) EXPECT_EQ(end, LocusEnd::kSecondLimit);
  for (const LocusPoint& point : tori.points) {
    EXPECT_NEAR(point.first, point.second * point.second, 1e-12);
    EXPECT_NEAR(point.angle, 1.5 + point.first, 1e-12);
  }
  std::vector<std::string> labels = labels_of(tori);
  std::sort(labels.begin(), labels.end());
  EXPECT_EQ(labels, (Labels{"PDNS", "R3", "R3", "R4", "R4"}));
}

// Multipliers -(1 + q - p^2) and -(1 + p - q) of the fixed point 0: the doublings q = p^2 and p = q
// cross at 0 and 1, each with its vector.
TEST(LocusPoints, DoublingsCross) {
  const ZeroProblem problem = periodic_points(plane_map([](const auto& x, const auto& p,
                                                           const auto& q) {
    using S = std::decay_t<decltype(p)>;
    return std::vector<S>{S(-1.0) * (S(1.0) + q - p * p) * x[0], S(-1.0) * (S(1.0) + p - q) * x[1]};
  }));
  const Locus locus = traced(problem, plane(-0.5, 0.9, -1.0, 1.0),
                             {LocusKind::kPeriodDoubling, Vector::Zero(2), 0.4, 0.17, {}});
  for (const LocusPoint& point : locus.points)
    EXPECT_NEAR(point.second, point.first * point.first, 1e-12);
  EXPECT_EQ(labels_of(locus), Labels{"PDPD"});
  EXPECT_NEAR(only(locus, LocusPointKind::kTwoDoublings).first, 0.0, 1e-12);
  EXPECT_NEAR(only(locus, LocusPointKind::kTwoDoublings).second, 0.0, 1e-12);
}

}  // namespace
}  // namespace graze
