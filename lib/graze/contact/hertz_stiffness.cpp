#include "graze/contact/hertz_stiffness.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <cmath>
#include <numbers>

#include "graze/base/detail/bracketed_zero.hpp"

namespace graze {
namespace {

using boost::math::ellint_1, boost::math::ellint_d;

// With D = (K - E)/e^2 nothing cancels: [E/(1 - e^2) - K]/e^2 = (K - D)/(1 - e^2).
double along(double e) { return ellint_d(e); }
double across(double e) { return (ellint_1(e) - ellint_d(e)) / ((1.0 - e) * (1.0 + e)); }

// Curvatures further apart than this touch along a line: 1 - e is 1e-11 there, and its rounding a
// hundred-thousandth of it.
constexpr double kLargestRatio = 1e10;

// e of the ellipse for 1 <= B/A <= kLargestRatio.
double eccentricity(double ratio) {
  if (!(ratio > 1.0)) return 0.0;
  // In l = log(1 - e), from 0 down: across/along grows beyond every bound there.
  const auto miss = [&](double l) {
    const double e = -std::expm1(l);
    return std::log(across(e) / along(e) / ratio);
  };
  double low = -1.0;
  while (!(miss(low) > 0.0)) low *= 2.0;
  const auto [a, b] = bracketed_zero(miss, {low, miss(low)}, {0.0, -std::log(ratio)});
  return -std::expm1(0.5 * (a + b));
}

}  // namespace

std::optional<double> hertz_stiffness(const ElasticBody& first, const ElasticBody& second,
                                      double angle) {
  const auto curvature = [](const ElasticBody& body, std::size_t plane) {
    return 1.0 / body.radii[plane];
  };
  const auto compliance = [](const ElasticBody& body) {
    return (1.0 - body.poisson_ratio * body.poisson_ratio) / body.modulus;
  };
  const double sum = 0.5 * (curvature(first, 0) + curvature(first, 1) + curvature(second, 0) +
                            curvature(second, 1));
  const double d1 = curvature(first, 0) - curvature(first, 1);
  const double d2 = curvature(second, 0) - curvature(second, 1);
  // |d1 + d2 e^{2 i angle}|, without a root of a difference.
  const double difference =
      0.5 * std::hypot(d1 + d2 * std::cos(2.0 * angle), d2 * std::sin(2.0 * angle));
  const double a = 0.5 * (sum - difference), b = 0.5 * (sum + difference);
  const double stiff = 1.0 / (compliance(first) + compliance(second));
  if (!(a > 0.0) || !(b <= kLargestRatio * a) || !std::isfinite(b) || !(stiff > 0.0) ||
      !std::isfinite(stiff))
    return {};
  const double e = eccentricity(b / a);
  return 2.0 * std::numbers::pi / 3.0 * stiff * std::pow(ellint_1(e), -1.5) *
         std::sqrt(along(e) / a);
}

}  // namespace graze
