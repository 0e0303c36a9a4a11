#include "graze/contact/contact_force.hpp"

namespace graze {

double ContactForce::rate_at(double x, double v, const ContactForce& rates) const {
  double rate = rates.stiffness * power(x);
  // d x^n/dn = x^n ln x
  const double by_exponent = x != 0.0 ? power(x) * std::log(std::abs(x)) : 0.0;
  rate += rates.exponent * stiffness * by_exponent;
  if (is_capped(x, v)) return v > 0.0 ? 2.0 * rate : 0.0;
  if (!acts(x, v)) return rate;
  if (coefficient != 0.0 || rates.coefficient != 0.0) {
    ContactForce unit = *this;
    unit.coefficient = 1.0;
    rate += rates.coefficient * unit.resistance(x) * v;
  }
  if (damping == ContactDamping::kPower) rate += rates.exponent * coefficient * by_exponent * v;
  if (damping == ContactDamping::kApproach && x != 0.0)
    rate += 0.5 * rates.exponent * std::log(std::abs(x)) * resistance(x) * v;
  if (damping == ContactDamping::kStep)
    rate -= resistance_slope(x) * x / onset_depth * rates.onset_depth * v;
  if (damping == ContactDamping::kOnset && x < onset_depth) {
    const double stretch = 2.0 / onset_depth *
                           ((x - onset_depth) * rates.onset_sharpness -
                            onset_sharpness * x / onset_depth * rates.onset_depth);
    rate += stretch * resistance(x) * v;
  }
  return rate;
}

}  // namespace graze
