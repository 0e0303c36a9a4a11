#include "graze/contact/contact_force.hpp"

namespace graze {

double ContactForce::rate_at(double x, double v, const ContactForce& rates) const {
  double rate = rates.stiffness * power(x);
  if (coefficient != 0.0 || rates.coefficient != 0.0) {
    ContactForce unit = *this;
    unit.coefficient = 1.0;
    rate += rates.coefficient * unit.resistance(x) * v;
  }
  if (rates.exponent != 0.0 && x != 0.0) {
    // d x^n/dn = x^n ln x
    const double by_exponent = power(x) * std::log(std::abs(x));
    rate += rates.exponent * stiffness * by_exponent;
    if (damping == ContactDamping::kPower) rate += rates.exponent * coefficient * by_exponent * v;
  }
  if (damping == ContactDamping::kOnset && x < onset_depth) {
    const double stretch = 2.0 / onset_depth *
                           ((x - onset_depth) * rates.onset_sharpness -
                            onset_sharpness * x / onset_depth * rates.onset_depth);
    rate += stretch * resistance(x) * v;
  }
  return rate;
}

}  // namespace graze
