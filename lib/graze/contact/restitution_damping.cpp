#include "graze/contact/detail/restitution_damping.hpp"

#include <boost/math/special_functions/log1p.hpp>
#include <cmath>
#include <numbers>

#include "graze/base/detail/bracketed_zero.hpp"

namespace graze {
namespace {

using boost::math::log1pmx;  // ln(1 + x) - x

// arccos(zeta)/sqrt(1 - zeta^2), and its continuation beyond 1.
double angle_over_sine(double zeta) {
  if (zeta == 1.0) return 1.0;
  const double product = (1.0 - zeta) * (1.0 + zeta);
  if (zeta < 1.0) return std::acos(zeta) / std::sqrt(product);
  return std::acosh(zeta) / std::sqrt(-product);
}

}  // namespace

double damping_ratio_of(double restitution) {
  const double decrement = -std::log(restitution);
  return decrement / std::hypot(std::numbers::pi, decrement);
}

double restitution_at_zero_depth(double zeta) {
  if (zeta >= 1.0) return 0.0;
  return std::exp(-std::numbers::pi * zeta / std::sqrt((1.0 - zeta) * (1.0 + zeta)));
}

double restitution_at_zero_force(double zeta) {
  return std::exp(-2.0 * zeta * angle_over_sine(zeta));
}

double damping_ratio_at_zero_force(double restitution) {
  if (restitution == 1.0) return 0.0;
  const double decrement = -std::log(restitution);
  const auto miss = [&](double zeta) { return 2.0 * zeta * angle_over_sine(zeta) - decrement; };
  double high = 1.0;
  while (miss(high) <= 0.0) high *= 2.0;
  return bracketed_zero(miss, {0.0, -decrement}, {high, miss(high)}).second;
}

// In u = A e: ln(1 - u) + u = ln(1 + A) - A, both falling from 0.
double restitution_of_power_damping(double a) {
  if (a == 0.0) return 1.0;
  const double meant = log1pmx(a);
  const auto miss = [&](double u) { return log1pmx(-u) - meant; };
  const double high = std::fmin(a, std::nextafter(1.0, 0.0));
  if (!(miss(high) < 0.0)) return high / a;
  // The left side falls faster than -u^2/2 and the right one slower than -A^2/2.
  double low = high;
  while (miss(low) <= 0.0) low *= 0.5;
  return bracketed_zero(miss, {low, miss(low)}, {high, miss(high)}).second / a;
}

double power_damping_of(double restitution) {
  if (restitution == 1.0) return 0.0;
  const auto miss = [&](double a) { return log1pmx(a) - log1pmx(-a * restitution); };
  // A = 1 - e falls short. As e tends to 0, A e tends to 1, faster than any power.
  const double low = 1.0 - restitution;
  double high = std::nextafter(1.0, 0.0) / restitution;
  while (high * restitution >= 1.0) high = std::nextafter(high, 0.0);  // but for its rounding
  if (!(miss(high) > 0.0)) return high;
  return bracketed_zero(miss, {low, miss(low)}, {high, miss(high)}).second;
}

double hunt_crossley_damping(double restitution) { return 1.5 * (1.0 - restitution); }

double lankarani_nikravesh_damping(double restitution) {
  return 0.75 * (1.0 - restitution) * (1.0 + restitution);
}

double flores_damping(double restitution) { return 1.6 * (1.0 - restitution) / restitution; }

double jankowski_damping_ratio(double e) {
  return 4.5 * std::sqrt(5.0) * (1.0 - e * e) / (e * (e * (9.0 * std::numbers::pi - 16.0) + 16.0));
}

}  // namespace graze
