// Normal forms of folds, doublings and tori of maps for which they are known.
#include "graze/continuation/normal_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/continuation/map.hpp"
#include "known_problems.hpp"
#include "plane_maps.hpp"

namespace graze {
namespace {

using support::range;

constexpr double kB = 0.3;  // of Henon's map

// x -> f(x) with f' and df/dp.
template <class F, class Slope, class ByParameter>
Map scalar(const F& f, const Slope& slope, const ByParameter& by) {
  return Map{[=](const Vector& x, Parameters p) -> std::optional<MapEvaluation> {
    return MapEvaluation{Vector::Constant(1, f(x[0], p[0])),
                         Matrix::Constant(1, 1, slope(x[0], p[0])),
                         Matrix::Constant(1, 1, by(x[0], p[0]))};
  }};
}

std::optional<NormalForm> form_of(const Map& map, const ContinuationOptions& options,
                                  const Vector& start, double parameter, CriticalKind kind) {
  const ZeroProblem once = periodic_points(map), twice = periodic_points(map, 2);
  const auto at = solve_at(once, options, start, parameter);
  if (!at) return {};
  const Branch branch = trace_branch(once, options, *at);
  const auto found = branch.critical_of(kind);
  if (found.size() != 1) return {};
  const SolutionPoint& point = found[0].point;
  return kind == CriticalKind::kFold ? fold_form(once, options, point)
         : kind == CriticalKind::kTorus
             ? torus_form(once, options, point, found[0].multiplier->value, twice,
                          twice_round(point))
             : doubling_form(once, options, point, twice, twice_round(point));
}

std::optional<NormalForm> doubling_of(const Map& map, double from, double to, double start) {
  return form_of(map, range(from, to), Vector::Constant(1, start), 0.5 * (from + to) - 0.05,
                 CriticalKind::kPeriodDoubling);
}

// Where f' = -1 b is the square of f'' over 4, and the third derivative over 6.
TEST(NormalForms, OfScalarDoublings) {
  const auto ricker = doubling_of(
      scalar([](double x, double r) { return x * std::exp(r * (1.0 - x)); },
             [](double x, double r) { return (1.0 - r * x) * std::exp(r * (1.0 - x)); },
             [](double x, double r) { return x * (1.0 - x) * std::exp(r * (1.0 - x)); }),
      1.0, 2.5, 1.0);
  ASSERT_TRUE(ricker);
  EXPECT_NEAR(ricker->coefficient, 2.0 / 3.0, 1e-10);
  EXPECT_GT(ricker->opening, 0.0);
  const auto logistic = doubling_of(scalar([](double x, double p) { return p * x * (1.0 - x); },
                                           [](double x, double p) { return p * (1.0 - 2.0 * x); },
                                           [](double x, double) { return x * (1.0 - x); }),
                                    2.0, 3.5, 0.6);
  ASSERT_TRUE(logistic);
  EXPECT_NEAR(logistic->coefficient, 9.0, 1e-9);
  // Subcritical: x -> -p x + 2 x^2 - 6 x^3.
  const auto cubic =
      doubling_of(scalar([](double x, double p) { return -p * x + 2.0 * x * x - 6.0 * x * x * x; },
                         [](double x, double p) { return -p + 4.0 * x - 18.0 * x * x; },
                         [](double x, double) { return -x; }),
                  0.5, 1.5, 0.0);
  ASSERT_TRUE(cubic);
  EXPECT_NEAR(cubic->coefficient, 4.0 - 6.0, 1e-9);
  EXPECT_LT(cubic->opening, 0.0);
}

// x -> 1 - p x^2 + y, y -> b x; B(u, v) = (-2 p u_1 v_1, 0), and no third derivative.
TEST(NormalForms, OfHenonsMap) {
  const Map henon{[](const Vector& x, Parameters p) -> std::optional<MapEvaluation> {
    MapEvaluation at{Vector(2), Matrix(2, 2), Vector(2)};
    at.image << 1.0 - p[0] * x[0] * x[0] + x[1], kB * x[0];
    at.jacobian << -2.0 * p[0] * x[0], 1.0, kB, 0.0;
    at.by_parameters << -x[0] * x[0], 0.0;
    return at;
  }};
  // A q = m q with q = (m, b), and the left vector (m, 1).
  const auto known = [](double p, double x, double multiplier) {
    const Vector q = Vector{{multiplier, kB}}.normalized();
    Vector left{{multiplier, 1.0}};
    left /= left.dot(q);
    const double bend = -2.0 * p * q[0] * q[0];
    if (multiplier > 0.0) return 0.5 * left[0] * bend;
    // (1 - A)^-1 (bend, 0) begins so.
    const double moved = bend / (1.0 + 2.0 * p * x - kB);
    return 0.5 * left[0] * -2.0 * p * q[0] * moved;
  };
  const double doubling = 0.75 * (1.0 - kB) * (1.0 - kB), fold = -0.25 * (1.0 - kB) * (1.0 - kB);
  const auto of_doubling =
      form_of(henon, range(0.1, 0.6), Vector{{0.8, 0.3 * 0.8}}, 0.2, CriticalKind::kPeriodDoubling);
  ASSERT_TRUE(of_doubling);
  EXPECT_NEAR(of_doubling->coefficient, known(doubling, (1.0 - kB) / (2.0 * doubling), -1.0), 1e-9);
  const auto of_fold =
      form_of(henon, range(-0.2, 0.2), Vector{{0.9, 0.3 * 0.9}}, 0.1, CriticalKind::kFold);
  ASSERT_TRUE(of_fold);
  EXPECT_NEAR(std::abs(of_fold->coefficient),
              std::abs(known(fold, -(1.0 - kB) / (2.0 * fold), 1.0)), 1e-9);
}

// x -> r x (1 - y), y -> x: a torus at r = 2, multipliers e^{+-i pi/3}. No third derivative, B(u,
// v) = (-r (u_1 v_2 + u_2 v_1), 0); modulus sqrt(r - 1).
TEST(NormalForms, OfTheDelayedLogisticMap) {
  const Map delayed{[](const Vector& x, Parameters p) -> std::optional<MapEvaluation> {
    MapEvaluation at{Vector(2), Matrix(2, 2), Vector(2)};
    at.image << p[0] * x[0] * (1.0 - x[1]), x[0];
    at.jacobian << p[0] * (1.0 - x[1]), -p[0] * x[0], 1.0, 0.0;
    at.by_parameters << x[0] * (1.0 - x[1]), 0.0;
    return at;
  }};
  const auto form =
      form_of(delayed, range(1.5, 2.5), Vector{{0.45, 0.45}}, 1.8, CriticalKind::kTorus);
  ASSERT_TRUE(form);
  const Complex mu = std::polar(1.0, std::numbers::pi / 3.0);
  const Eigen::MatrixXcd slope{{Complex(1.0), Complex(-1.0)}, {Complex(1.0), Complex(0.0)}};
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(2, 2);
  const ComplexVector q = ComplexVector{{mu, Complex(1.0)}}.normalized();
  ComplexVector left{{mu, Complex(-1.0)}};
  left /= left.cwiseProduct(q).sum();
  const auto bent = [](const ComplexVector& u, const ComplexVector& v) {
    return ComplexVector{{-2.0 * (u[0] * v[1] + u[1] * v[0]), Complex(0.0)}};
  };
  const ComplexVector mean = solve(one - slope, bent(q, q.conjugate())),
                      twice = solve(mu * mu * one - slope, bent(q, q));
  const Complex cubic =
      left.cwiseProduct(bent(q, mean) + 0.5 * bent(q.conjugate(), twice)).sum() / mu;
  EXPECT_NEAR(form->coefficient, cubic.real(), 1e-10);
  EXPECT_NEAR(form->opening, -cubic.real() / 0.5, 1e-8);
}

// Where b = q^2 - 1/4 vanishes on the doublings of x -> -p x + q x^2 - x^3/4, at p = 1; and where
// a = q + 0.1 of z -> mu (1 + p + (q + 0.1) |z|^2 - |z|^4) z does, at p = 0.
TEST(NormalForms, VanishAtGeneralisedPoints) {
  const auto degenerate = [](const Map& map, LocusOptions options, const LocusStart& start) {
    const ZeroProblem twice = periodic_points(map, 2);
    options.coefficient = [&](const LocusPoint& at) {
      Vector both(2 * at.u.size());
      both << at.u, at.u;
      return cubic_coefficient(twice, both, std::array{at.first, at.second},
                               std::polar(1.0, at.angle));
    };
    const Locus locus = *trace_locus(periodic_points(map), options, start);
    std::vector<LocusSpecialPoint> list;
    for (const LocusSpecialPoint& special : locus.special)
      if (special.kind == LocusPointKind::kDegenerateDoubling ||
          special.kind == LocusPointKind::kDegenerateTorus)
        list.push_back(special);
    return list;
  };
  const Map doubling = support::plane_map([](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    return std::vector<S>{S(-1.0) * p * x[0] + q * x[0] * x[0] - S(0.25) * x[0] * x[0] * x[0]};
  });
  const auto flips = degenerate(doubling, support::plane(0.5, 1.5, -1.0, 0.9),
                                {LocusKind::kPeriodDoubling, Vector{{0.01}}, 1.1, 0.2, {}});
  ASSERT_EQ(flips.size(), 2u);
  for (const LocusSpecialPoint& flip : flips) {
    EXPECT_EQ(flip.kind, LocusPointKind::kDegenerateDoubling);
    EXPECT_NEAR(std::abs(flip.point.second), 0.5, 1e-10);
  }
  const double angle = 1.1;
  const Map turned = support::plane_map([angle](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    const S square = x[0] * x[0] + x[1] * x[1];
    const S stretch = S(1.0) + p + (q + S(0.1)) * square - square * square;
    const S c(std::cos(angle)), s(std::sin(angle));
    return std::vector<S>{stretch * (c * x[0] - s * x[1]), stretch * (s * x[0] + c * x[1])};
  });
  const auto tori =
      degenerate(turned, support::plane(-0.5, 0.5, -1.0, 0.9),
                 {LocusKind::kTorus, Vector{{0.0, 0.0}}, 0.02, 0.3, std::polar(1.0, angle)});
  ASSERT_EQ(tori.size(), 1u);
  EXPECT_EQ(tori[0].kind, LocusPointKind::kDegenerateTorus);
  EXPECT_NEAR(tori[0].point.second, -0.1, 1e-10);
}

// A coefficient has poles where others of the values that are tested pass zero: no point there.
TEST(NormalForms, HaveNoZerosAtTheirPoles) {
  const Map henon = support::henon_plane();
  const ZeroProblem once = periodic_points(henon), twice = periodic_points(henon, 2);
  LocusOptions options = support::plane(-1.0, 4.0, -1.8, 0.8);
  const LocusStart start{LocusKind::kPeriodDoubling, Vector{{0.9, 0.2}}, 0.5, 0.2, {}};
  const std::vector<std::string> without = support::labels_of(*trace_locus(once, options, start));
  int evaluated = 0;
  options.coefficient = [&](const LocusPoint& at) {
    ++evaluated;
    Vector both(4);
    both << at.u, at.u;
    return cubic_coefficient(twice, both, std::array{at.first, at.second}, -1.0);
  };
  EXPECT_EQ(support::labels_of(*trace_locus(once, options, start)), without);
  EXPECT_EQ(without, std::vector<std::string>{"R2"});
  EXPECT_GT(evaluated, 20);
}

}  // namespace
}  // namespace graze
