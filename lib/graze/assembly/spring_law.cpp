#include "graze/assembly/detail/spring_law.hpp"

#include <cmath>
#include <numbers>

#include "graze/contact/detail/restitution_damping.hpp"

namespace graze {
namespace {

constexpr double kSharpness = 3.0;  // Q of Yigit, Ulsoy & Scott (1990)

// A number and its rate.
struct Moving {
  double value = 0.0, rate = 0.0;
};

Moving moving(const std::optional<double>& value, const std::optional<double>& rate) {
  return {value.value_or(0.0), rate.value_or(0.0)};
}

// zeta over e where the contact ends at zero depth: x/sqrt(pi^2 + x^2), x = -ln e.
Moving ratio_in_print(const Moving& e) {
  const double x = -std::log(e.value), size = std::hypot(std::numbers::pi, x);
  const double slope = std::numbers::pi * std::numbers::pi / (size * size * size);
  return {damping_ratio_of(e.value), -slope * e.rate / e.value};
}

// zeta over e where the contact ends at zero force: -ln e = 2 zeta g, g = arccos(zeta)/sqrt(1 -
// zeta^2), (1 - zeta^2) g' = zeta g - 1; at zeta = 1 g' = -1/3.
Moving ratio_at_zero_force(const Moving& e) {
  const double zeta = damping_ratio_at_zero_force(e.value);
  const double g = zeta > 0.0 ? -std::log(e.value) / (2.0 * zeta) : 0.5 * std::numbers::pi;
  const double near_one = 1.0 - zeta;
  // (zeta g - 1)/(1 - zeta^2) loses eps/(1 - zeta) there; its series loses (1 - zeta)^2.
  const double slope = std::abs(near_one) < 1e-5 ? -1.0 / 3.0 - 4.0 / 15.0 * near_one
                                                 : (zeta * g - 1.0) / (near_one * (1.0 + zeta));
  return {zeta, -e.rate / (2.0 * e.value * (g + zeta * slope))};
}

// A over e: A (1 + e) = ln[(1 + A)/(1 - A e)], differentiated:
//   dA/de = A e (1 + A)/{(1 + e) [(1 - e) - A e]}.
Moving power_in_full(const Moving& e) {
  const double a = power_damping_of(e.value), r = e.value;
  if (a == 0.0) return {0.0, -1.5 * e.rate};  // A = 3 (1 - e)/2 + ..
  return {a, a * r * (1.0 + a) / ((1.0 + r) * ((1.0 - r) - a * r)) * e.rate};
}

Moving power_in_print(ContactModel model, const Moving& e) {
  const double r = e.value;
  switch (model) {
    case ContactModel::kLankaraniNikravesh:
      return {lankarani_nikravesh_damping(r), -1.5 * r * e.rate};
    case ContactModel::kFlores:
      return {flores_damping(r), -1.6 * e.rate / (r * r)};
    default:
      return {hunt_crossley_damping(r), -1.5 * e.rate};
  }
}

// zeta over e of Jankowski's model.
Moving jankowski_ratio(const Moving& e) {
  const double r = e.value, zeta = jankowski_damping_ratio(r), p = 9.0 * std::numbers::pi - 16.0;
  const double slope = 4.5 * std::sqrt(5.0) *
                       (-2.0 * r / (r * (r * p + 16.0)) -
                        (1.0 - r * r) * (2.0 * r * p + 16.0) / std::pow(r * (r * p + 16.0), 2.0));
  return {zeta, slope * e.rate};
}

// C = 2 zeta sqrt(k m).
Moving of_ratio(const Moving& zeta, const Moving& k, const Moving& mass) {
  const double root = std::sqrt(k.value * mass.value);
  return {2.0 * zeta.value * root,
          2.0 * zeta.rate * root + zeta.value * root * (k.rate / k.value + mass.rate / mass.value)};
}

// C = factor k.
Moving of_stiffness(const Moving& factor, const Moving& k) {
  return {factor.value * k.value, factor.rate * k.value + factor.value * k.rate};
}

Moving coefficient(const Spring& spring, const SpringDamping& damping, const SpringDamping& rate,
                   const Moving& k) {
  if (damping.coefficient) return moving(damping.coefficient, rate.coefficient);
  const Moving e = moving(damping.restitution, rate.restitution);
  const Moving mass = moving(damping.mass, rate.mass);
  const Moving alpha = moving(damping.alpha, rate.alpha);
  switch (damping.model) {
    case ContactModel::kKelvinVoigt:
    case ContactModel::kLeeWang2: {
      if (damping.ratio) return of_ratio(moving(damping.ratio, rate.ratio), k, mass);
      const bool at_force = damping.exact && spring.release == Separation::kAtZeroForce;
      return of_ratio(at_force ? ratio_at_zero_force(e) : ratio_in_print(e), k, mass);
    }
    case ContactModel::kAdams:
    case ContactModel::kElastoGap:
    case ContactModel::kJankowski:
      return of_ratio(damping.ratio ? moving(damping.ratio, rate.ratio) : jankowski_ratio(e), k,
                      mass);
    case ContactModel::kLeeWang1:
      return of_stiffness({0.75 * alpha.value, 0.75 * alpha.rate}, k);
    case ContactModel::kHuntCrossley:
    case ContactModel::kLankaraniNikravesh:
    case ContactModel::kFlores:
      break;
  }
  if (damping.alpha) return of_stiffness({1.5 * alpha.value, 1.5 * alpha.rate}, k);
  const Moving v = moving(damping.speed, rate.speed);
  const Moving a = damping.exact ? power_in_full(e) : power_in_print(damping.model, e);
  return of_stiffness({a.value / v.value, (a.rate - a.value * v.rate / v.value) / v.value}, k);
}

ContactDamping shape(ContactModel model) {
  switch (model) {
    case ContactModel::kKelvinVoigt:
      return ContactDamping::kConstant;
    case ContactModel::kLeeWang1:
      return ContactDamping::kDepth;
    case ContactModel::kLeeWang2:
      return ContactDamping::kOnset;
    case ContactModel::kHuntCrossley:
    case ContactModel::kLankaraniNikravesh:
    case ContactModel::kFlores:
      return ContactDamping::kPower;
    case ContactModel::kAdams:
      return ContactDamping::kStep;
    case ContactModel::kJankowski:
      return ContactDamping::kApproach;
    case ContactModel::kElastoGap:
      return ContactDamping::kCapped;
  }
  return ContactDamping::kNone;
}

double stiffness_of(const Spring& spring) {
  if (!spring.geometry) return spring.stiffness;
  const SpringGeometry& geometry = *spring.geometry;
  return *hertz_stiffness(geometry.bodies[0], geometry.bodies[1], geometry.angle);
}

}  // namespace

Spring as_given(const Spring& spring, double stiffness) {
  Spring given = spring;
  if (!given.is_residual) return given;
  given.is_residual = false;
  given.stiffness = stiffness;
  given.exponent = 1.0;
  return given;
}

Spring rate_as_given(const Spring& rate, double stiffness_rate) {
  Spring given = as_given(rate, stiffness_rate);
  if (rate.is_residual) given.exponent = 0.0;
  return given;
}

ContactForce spring_law(const Spring& spring) {
  ContactForce law;
  law.stiffness = stiffness_of(spring);
  law.exponent = spring.geometry ? 1.5 : spring.exponent;
  law.separation = spring.release;
  if (!spring.damping) return law;
  const SpringDamping& damping = *spring.damping;
  law.damping = shape(damping.model);
  law.coefficient = coefficient(spring, damping, {}, {law.stiffness, 0.0}).value;
  if (!damping.onset) return law;
  law.onset_depth = *damping.onset;
  law.onset_sharpness = damping.sharpness.value_or(kSharpness);
  return law;
}

ContactForce spring_law_rate(const Spring& spring, const Spring& rate) {
  ContactForce law;
  law.exponent = spring.geometry ? 0.0 : rate.exponent;
  law.stiffness = spring.geometry ? 0.0 : rate.stiffness;
  if (!spring.damping) return law;
  const Moving k{stiffness_of(spring), law.stiffness};
  law.damping = shape(spring.damping->model);
  law.coefficient = coefficient(spring, *spring.damping, *rate.damping, k).rate;
  law.onset_depth = rate.damping->onset.value_or(0.0);
  law.onset_sharpness = rate.damping->sharpness.value_or(0.0);
  return law;
}

}  // namespace graze
