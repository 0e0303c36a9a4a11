// The free response of one mode, q'' + 2 delta q' + w^2 q = 0, in a form that holds across critical
// damping and for a free mass (w = 0):
//
//   q(s) = (c + delta S) q0 + S q0',   c = e^{-delta s} C,   S = e^{-delta s} sin(sqrt(D)
//   s)/sqrt(D)
//
// with D = w^2 - delta^2, C = cos(sqrt(D) s), and cosh, sinh for D < 0.
#pragma once

#include <cmath>
#include <limits>

namespace graze {

template <class Real>
struct FreeBasis {
  Real cosine_minus_one;  // c - 1
  Real cosine;            // c
  Real sine;              // S, s
};

template <class Real>
FreeBasis<Real> free_basis(const Real& omega, const Real& delta, const Real& discriminant,
                           const Real& s) {
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
  // Two decaying exponentials: cosh and sinh alone would overflow. The slow rate is not delta -
  // root, which is lost in rounding where the stiffness is soft against the damping.
  const Real quick_rate = delta + root, slow_rate = omega * omega / quick_rate;
  const Real slow = expm1(-slow_rate * s), fast = expm1(-quick_rate * s);
  const Real cosine_minus_one = (slow + fast) / 2;
  return {cosine_minus_one, 1 + cosine_minus_one, (slow - fast) / (2 * root)};
}

// Response from rest to a unit force that sets in at s = 0: the integral of S. Its closed form
// (1 - c - delta S)/w^2 cancels while the force has hardly been felt; there the power series is
// summed (at most one digit is lost below (2 delta + w) s = 2).
template <class Real>
Real step_response(const Real& omega, const Real& delta, const Real& discriminant, const Real& s) {
  using std::abs, std::expm1, std::sqrt;
  if ((2 * delta + omega) * abs(s) < 2) {
    // S = sum a_n s^n with a_0 = 0, a_1 = 1 from S'' = -2 delta S' - w^2 S; A = sum a_n
    // s^(n+1)/(n+1)
    Real before = 0, now = s, sum = s * s / 2;
    // 200 terms leave nothing of 2^n/n! in any scalar in use.
    for (int n = 0; n < 200; ++n) {
      const Real next =
          -(2 * delta * s * (n + 1) * now + omega * omega * s * s * before) / ((n + 2) * (n + 1));
      before = now;
      now = next;
      const Real term = now * s / (n + 3);
      sum += term;
      if (abs(term) + abs(before * s) <= std::numeric_limits<Real>::epsilon() * abs(sum) / 4) break;
    }
    return sum;
  }
  if (discriminant < 0) {
    const Real root = sqrt(-discriminant);
    if (2 * root * abs(s) >= 1) {
      const Real fast = delta + root, slow = omega * omega / fast;
      const Real of_slow = slow * s == 0 ? s : Real(-expm1(-slow * s) / slow);
      return (of_slow + expm1(-fast * s) / fast) / (2 * root);
    }
  }
  const FreeBasis<Real> basis = free_basis(omega, delta, discriminant, s);
  return -(basis.cosine_minus_one + delta * basis.sine) / (omega * omega);
}

}  // namespace graze
