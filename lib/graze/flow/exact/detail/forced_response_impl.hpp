// Definitions of forced_response.hpp; included by one translation unit per scalar.
//
// With the roots l, l* of the mode (or its two rates) and E(l) = (e^{iWs} - e^{ls})/(iW - l) it is
// the divided difference (E(l) - E(l*))/(l - l*) times e^{i theta}. Which form does not cancel
// depends on the flight:
//   - nothing oscillates or decays much, (2 delta + w + W) s < 2: the power series, led by s^2/2;
//   - the roots are distinct over the flight, |l - l*| s >= 1 and |l - l*| >= w: the divided
//     difference, E itself written for l near iW;
//   - else the mode is near critical, |w^2 - W^2 + 2 i delta W| is w^2 + W^2 to a factor, or W s
//     is not small: the harmonic response less the free motion from its start.
#pragma once

#include <limits>

#include "graze/flow/exact/detail/forced_response.hpp"
#include "graze/flow/exact/detail/free_basis.hpp"

namespace graze {
namespace exact_flow_detail {

// e^{(re + i im) s}
template <class Real>
PlanarNumber<Real> exponential(const Real& re, const Real& im, const Real& s) {
  using std::cos, std::exp, std::sin;
  const Real size = exp(re * s);
  return {size * cos(im * s), size * sin(im * s)};
}

// (e^{i W s} - e^{l s})/(i W - l) for l = -decay + i v, without cancellation as l -> i W.
template <class Real>
PlanarNumber<Real> divided_exponential(const Real& decay, const Real& v, const Real& frequency,
                                       const Real& s) {
  using std::cos, std::expm1, std::sin;
  const PlanarNumber<Real> root = exponential(Real(-decay), v, s);
  const Real detuning = frequency - v;
  if (decay == 0 && detuning == 0) return {root.re * s, root.im * s};
  PlanarNumber<Real> difference;
  if (decay * s > 1) {  // one is less than half of the other; and the quotient would overflow
    difference = {cos(frequency * s) - root.re, sin(frequency * s) - root.im};
  } else {
    const Real growth = expm1(decay * s), half = sin(detuning * s / 2);
    difference = root * PlanarNumber<Real>{growth * cos(detuning * s) - 2 * half * half,
                                           (1 + growth) * sin(detuning * s)};
  }
  return difference / PlanarNumber<Real>{decay, detuning};
}

// The terms are at most s^2/2 (2 delta + w + W)^n s^n/n!.
template <class Real>
PlanarNumber<Real> forced_by_series(const ModeFlow<Real>& mode, const Real& frequency,
                                    const Real& theta, const Real& s) {
  using std::abs, std::cos, std::sin;
  const Real turn = frequency * s, damping = 2 * mode.delta * s;
  const Real stiffness = mode.omega * mode.omega * s * s;
  const Real size = abs(turn) + abs(damping) + mode.omega * abs(s);
  const Real c = cos(theta), n = sin(theta);
  const Real quarter[] = {c, -n, -c, n};
  Real force = s * s;        // times turn^k/k!
  Real largest = s * s / 2;  // of what the term may be
  Real before = 0, now = 0;  // coefficients k and k + 1, times s^k, s^(k+1)
  Real q = 0, rate = 0;      // rate: times s
  // 200 terms leave nothing of 2^k/k! in any scalar in use.
  for (int k = 0; k < 200; ++k) {
    const Real next = (force * quarter[k % 4] - damping * (k + 1) * now - stiffness * before) /
                      ((k + 1) * (k + 2));
    before = now;
    now = next;
    q += now;
    rate += (k + 2) * now;
    force *= turn / (k + 1);
    largest *= size / (k + 1);
    if (largest <= std::numeric_limits<Real>::epsilon() * abs(q) / 4) break;
  }
  return {q, s == 0 ? Real(0) : Real(rate / s)};
}

// From E(l) and E(l*) for the displacement, and from l E(l) and l* E(l*) for the velocity.
template <class Real>
PlanarNumber<Real> forced_by_roots(const ModeFlow<Real>& mode, const Real& frequency,
                                   const Real& theta, const Real& s) {
  using std::abs, std::cos, std::sin, std::sqrt;
  const Real c = cos(theta), n = sin(theta), root = sqrt(abs(mode.discriminant));
  if (mode.discriminant < 0) {
    const Real fast = mode.delta + root, slow = mode.omega * mode.omega / fast;
    const PlanarNumber<Real> a = divided_exponential(slow, Real(0), frequency, s);
    const PlanarNumber<Real> b = divided_exponential(fast, Real(0), frequency, s);
    return {((a.re - b.re) * c - (a.im - b.im) * n) / (2 * root),
            ((fast * b.re - slow * a.re) * c - (fast * b.im - slow * a.im) * n) / (2 * root)};
  }
  const PlanarNumber<Real> up = divided_exponential(mode.delta, root, frequency, s);
  const PlanarNumber<Real> down = divided_exponential(mode.delta, Real(-root), frequency, s);
  const PlanarNumber<Real> numerator{up.re - down.re, up.im - down.im};
  const PlanarNumber<Real> rate{-mode.delta * (up.re - down.re) - root * (up.im + down.im),
                                -mode.delta * (up.im - down.im) + root * (up.re + down.re)};
  // Re(e^{i theta} z/(2 i root)) = (Im z cos + Re z sin)/(2 root)
  return {(numerator.im * c + numerator.re * n) / (2 * root),
          (rate.im * c + rate.re * n) / (2 * root)};
}

template <class Real>
PlanarNumber<Real> forced_by_difference(const ModeFlow<Real>& mode, const Real& frequency,
                                        const Real& theta, const Real& s) {
  using std::cos, std::sin;
  const Real w2 = mode.omega * mode.omega;
  const PlanarNumber<Real> response =
      PlanarNumber<Real>{1, 0} /
      PlanarNumber<Real>{(mode.omega - frequency) * (mode.omega + frequency),
                         2 * mode.delta * frequency};
  const auto at = [&](const Real& phase) {
    const Real c = cos(phase), n = sin(phase);
    return PlanarNumber<Real>{response.re * c - response.im * n,
                              -frequency * (response.re * n + response.im * c)};
  };
  const PlanarNumber<Real> start = at(theta), end = at(Real(theta + frequency * s));
  const FreeBasis<Real> basis = free_basis(mode.omega, mode.delta, mode.discriminant, s);
  const Real& sine = basis.sine;
  return {end.re - (basis.cosine + mode.delta * sine) * start.re - sine * start.im,
          end.im + w2 * sine * start.re - (basis.cosine - mode.delta * sine) * start.im};
}

}  // namespace exact_flow_detail

template <class Real>
PlanarNumber<Real> forced_response(const ModeFlow<Real>& mode, const Real& frequency,
                                   const Real& theta, const Real& s) {
  using namespace exact_flow_detail;
  using std::abs, std::sqrt;
  if ((2 * mode.delta + mode.omega + frequency) * abs(s) < 2)
    return forced_by_series(mode, frequency, theta, s);
  const Real apart = 2 * sqrt(abs(mode.discriminant));
  return apart * abs(s) >= 1 && apart >= mode.omega
             ? forced_by_roots(mode, frequency, theta, s)
             : forced_by_difference(mode, frequency, theta, s);
}

}  // namespace graze
