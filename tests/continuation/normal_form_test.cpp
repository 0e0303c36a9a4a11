// Normal forms of folds and doublings of maps for which they are known.
#include "graze/continuation/normal_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/continuation/map.hpp"
#include "known_problems.hpp"

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
  return kind == CriticalKind::kFold
             ? fold_form(once, options, point)
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

}  // namespace
}  // namespace graze
