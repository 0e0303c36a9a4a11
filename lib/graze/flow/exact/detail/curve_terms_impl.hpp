// Definitions of curve_terms.hpp for a scalar that no vector unit knows.
#pragma once

#include <cmath>
#include <limits>

#include "graze/flow/exact/detail/curve_terms.hpp"

namespace graze {
namespace curve_terms_detail {

// |k|; where its square leaves the range of the scalar, the sum of its parts bounds it.
template <class Real>
Real size_of(const PlanarNumber<Real>& k) {
  using std::abs, std::sqrt;
  const Real square = k.re * k.re + k.im * k.im;
  const bool in_range =
      square > std::numeric_limits<Real>::min() && square < std::numeric_limits<Real>::max();
  return in_range ? Real(sqrt(square)) : Real(abs(k.re) + abs(k.im));
}

// |l|
template <class Real>
Real rate_size_of(const Real& decay, const Real& frequency) {
  using std::sqrt;
  return decay == 0 ? frequency : Real(sqrt(decay * decay + frequency * frequency));
}

}  // namespace curve_terms_detail

template <class Real>
void CurveTerms<Real>::add(const Real& decay, const Real& frequency) {
  terms_.push_back(
      {decay, frequency, {}, 0, curve_terms_detail::rate_size_of(decay, frequency), 0});
}

template <class Real>
void CurveTerms<Real>::set(std::size_t i, const PlanarNumber<Real>& k, const Real& formed_from) {
  Term& term = terms_[i];
  term.coefficient = k;
  term.size = curve_terms_detail::size_of(k);
  term.rounded = term.size + formed_from;
}

template <class Real>
void CurveTerms<Real>::add_to(const Real& s, int m, CurvePoint<Real>& point,
                              TermShares<Real>& shares) const {
  using std::cos, std::expm1, std::sin;
  Real rounding = 0;
  Real decay_rate = 0, decay_minus_one = 0;  // modes often share their decay
  for (std::size_t j = 0; j < terms_.size(); ++j) {
    const Term& term = terms_[j];
    if (term.decay != decay_rate) {
      decay_rate = term.decay;
      decay_minus_one = expm1(-decay_rate * s);
    }
    const Real decay = 1 + decay_minus_one;
    const Real half = term.frequency * s / 2;
    const Real sine = sin(half), cosine = cos(half);
    const Real re_minus_one = decay_minus_one - decay * 2 * sine * sine;
    const Real re = 1 + re_minus_one, im = decay * 2 * sine * cosine;
    const PlanarNumber<Real> rate{-term.decay, term.frequency};
    PlanarNumber<Real> k = term.coefficient;
    Real size = decay * term.size, largest = term.rounded;  // |k l^m e^{l s}|
    for (int i = 0; i < m; ++i) {
      k = k * rate;
      size *= term.rate_size;
      largest *= term.rate_size;
    }
    const PlanarNumber<Real> next = k * rate, after = next * rate;
    const Real own = k.re * re - k.im * im;
    const Real slope = next.re * re - next.im * im;
    const Real curvature = after.re * re - after.im * im;
    const Real bound = size * term.rate_size * term.rate_size, third = bound * term.rate_size;
    point.value += m == 0 ? Real(k.re * re_minus_one - k.im * im) : own;
    point.slope += slope;
    point.curvature += curvature;
    point.bound += bound;
    point.third += third;
    rounding += largest * ((m == 0 ? Real(0) : decay) + s * term.rate_size);
    if (j >= kMostShares) continue;
    shares.slope[j] = slope;
    shares.curvature[j] = curvature;
    shares.third[j] = third;
    shares.fall[j] = own + size;
  }
  point.noise += kTermRoundings * std::numeric_limits<Real>::epsilon() * rounding;
}

}  // namespace graze
