// The (1, 1) motion of an oscillator of unit mass, frequency and force, solved by hand in more
// digits than the program has: a referee that shares nothing with it.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace graze::support {

using Real = long double;

// Displacement and speed at the impact as Re(.. e^{i phi}) of its phase phi.
struct ImpactResponse {
  std::complex<Real> kappa, speed;
};

// `ratio`: of the damping, below 1; `restitution`: constant.
inline ImpactResponse impact_response(Real ratio, Real restitution, Real frequency) {
  using Complex = std::complex<Real>;
  const Real period = 2 * std::numbers::pi_v<Real> / frequency;
  const Real root = std::sqrt(1 - ratio * ratio), decay = std::exp(-ratio * period);
  const Real c = decay * std::cos(root * period), s = decay * std::sin(root * period) / root;
  // E = [c + ratio s, s; -s, c - ratio s]; E J has its second column times -r.
  const Real e11 = c + ratio * s, e12 = s, e21 = -s, e22 = c - ratio * s;
  const Complex q = Real(1) / Complex(1 - frequency * frequency, 2 * ratio * frequency);
  const Complex v = Complex(0, frequency) * q;
  const Complex right1 = (1 - e11) * q - e12 * v, right2 = -e21 * q + (1 - e22) * v;
  const Real m11 = 1 - e11, m12 = restitution * e12, m21 = -e21, m22 = 1 + restitution * e22;
  const Real determinant = m11 * m22 - m12 * m21;
  return {(m22 * right1 - m12 * right2) / determinant, (m11 * right2 - m21 * right1) / determinant};
}

}  // namespace graze::support
