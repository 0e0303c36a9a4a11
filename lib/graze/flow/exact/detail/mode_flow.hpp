// One mode of the exact flow, x'' + 2 delta x' + w^2 x = f cos(theta + W s) + c: the form in which
// its motion is written, and the numbers of that form (exact_flow.hpp).
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

// A complex number; std::complex promises nothing for extended scalars.
template <class Real>
struct PlanarNumber {
  Real re = 0;
  Real im = 0;

  friend PlanarNumber operator*(const PlanarNumber& a, const PlanarNumber& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend PlanarNumber operator/(const PlanarNumber& a, const PlanarNumber& b) {
    const Real norm = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / norm, (a.im * b.re - a.re * b.im) / norm};
  }
};

// Writing motion as free part plus P_j multiplies rounding by |P_j| w^2/f_j, and by the rest
// position under a load over the reach of the stops. Up to this factor (8 of 53 bits) that is
// accepted; beyond, the response is taken from rest.
inline constexpr double kLargestAmplification = 256.0;

enum class ModeKind { kOscillatory, kOverdamped, kNearCritical, kFromRest };

template <class Real>
struct ModeFlow {
  ModeKind kind = ModeKind::kOscillatory;
  Real omega = 0, delta = 0;
  Real discriminant = 0;       // w^2 - delta^2
  Real first = 0, second = 0;  // oscillatory: delta, wd; overdamped: slow, fast rate; 1/s
  Real force = 0;              // f_j
  PlanarNumber<Real> forced;   // P_j; zero for a mode that answers from rest
  Real offset = 0;             // c_j/w_j^2; zero where the response to c_j is taken from rest
  Real load = 0;               // c_j of such a mode, else zero
};

}  // namespace graze
