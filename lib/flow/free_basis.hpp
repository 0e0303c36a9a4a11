// The free response of one mode, q'' + 2 delta q' + w^2 q = 0, in a form that holds across critical
// damping and for a free mass (w = 0):
//
//   q(s) = (c + delta S) q0 + S q0',   c = e^{-delta s} C,   S = e^{-delta s} sin(sqrt(D)
//   s)/sqrt(D)
//
// with D = w^2 - delta^2, C = cos(sqrt(D) s), and cosh, sinh for D < 0.
#pragma once

#include <cmath>

namespace graze {

template <class Real>
struct FreeBasis {
  Real cosine_minus_one;  // c - 1
  Real cosine;            // c
  Real sine;              // S, s
};

template <class Real>
FreeBasis<Real> free_basis(const Real& delta, const Real& discriminant, const Real& s) {
  using std::cos, std::exp, std::expm1, std::sin, std::sinh, std::sqrt;
  const Real decay_minus_one = expm1(-delta * s);
  const Real decay = 1 + decay_minus_one;
  if (discriminant >= 0) {
    const Real root = sqrt(discriminant);
    const Real half = root * s / 2;
    const Real sine_half = sin(half);
    const Real cosine_minus_one = -2 * sine_half * sine_half;
    const Real ratio = root * s == 0 ? s : 2 * sine_half * cos(half) / root;
    const Real difference = decay_minus_one + decay * cosine_minus_one;
    return {difference, 1 + difference, decay * ratio};
  }
  const Real root = sqrt(-discriminant);
  if (root * s < 1) {
    const Real half = sinh(root * s / 2);
    const Real difference = decay_minus_one + decay * 2 * half * half;
    return {difference, 1 + difference, decay * sinh(root * s) / root};
  }
  // Two decaying exponentials: cosh and sinh alone would overflow.
  const Real slow = exp((root - delta) * s), fast = exp(-(root + delta) * s);
  const Real cosine = (slow + fast) / 2;
  return {cosine - 1, cosine, (slow - fast) / (2 * root)};
}

}  // namespace graze
