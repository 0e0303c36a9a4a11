#include "graze/flow/exact/detail/term_kernels.hpp"

#include <array>
#include <cmath>

// This file is compiled once for every vector unit.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/flow/exact/term_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, kColumnStep>;
using Numbers = hn::Vec<Lanes>;

struct Turn {
  Numbers re_minus_one, im, decay;  // e^{l s} - 1, and e^{-decay s}
};

// a0 + a1 x + .. + a7 x^7, pairs first: three products deep instead of seven.
HWY_INLINE Numbers series(Numbers x, const std::array<double, 8>& a) {
  const Lanes d;
  const auto pair = [&](std::size_t low) {
    return hn::MulAdd(x, hn::Set(d, a[low + 1]), hn::Set(d, a[low]));
  };
  const Numbers x2 = hn::Mul(x, x);
  const Numbers low = hn::MulAdd(pair(2), x2, pair(0)), high = hn::MulAdd(pair(6), x2, pair(4));
  return hn::MulAdd(high, hn::Mul(x2, x2), low);
}

// Of an angle: 2 sin^2 and 2 sin cos, both of period pi.
struct Products {
  Numbers square, mixed;
};

// The angle less the nearest multiple of pi/2 is at most pi/4, where Taylor's series up to r^17 and
// r^16 leave less than 1e-19 and 3e-18; an odd multiple exchanges sine and cosine. Not those of the
// library, which take the angle up to pi/2: there the rounding of the coefficients shows, and
// sin^2 + cos^2 misses 1 by 4e-17 on the average, to which the energy of 1e6 arcs adds up.
HWY_INLINE Products products_near(Numbers angle) {
  static constexpr std::array<double, 8> kSine = {
      -1.0 / 6,        1.0 / 120 - 1.9e-17, -1.0 / 5040,          1.0 / 362880,
      -1.0 / 39916800, 1.0 / 6227020800,    -1.0 / 1307674368000, 1.0 / 355687428096000};
  static constexpr std::array<double, 8> kCosine = {
      -1.0 / 2,       1.0 / 24,        -1.0 / 720,         1.0 / 40320,
      -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
  const Lanes d;
  const Numbers turns = hn::Round(hn::Mul(angle, hn::Set(d, 0x1.45f306dc9c883p-1)));  // 2/pi
  // pi/2 in three parts, the first two so short that their multiples are exact.
  Numbers r = hn::NegMulAdd(turns, hn::Set(d, 0x1.921fb5p+0), angle);
  r = hn::NegMulAdd(turns, hn::Set(d, 0x1.110b46p-26), r);
  r = hn::NegMulAdd(turns, hn::Set(d, 0x1.1a62633145c07p-54), r);
  const Numbers r2 = hn::Mul(r, r);
  const Numbers sine = hn::MulAdd(hn::Mul(r, r2), series(r2, kSine), r);
  const Numbers cosine = hn::MulAdd(r2, series(r2, kCosine), hn::Set(d, 1.0));
  const Numbers half_turns = hn::Mul(turns, hn::Set(d, 0.5));
  const auto is_odd = hn::Ne(half_turns, hn::Round(half_turns));
  const Numbers twice = hn::Add(sine, sine), mixed = hn::Mul(twice, cosine);
  // 2 cos^2 = 2 - 2 sin^2, rounded once.
  return {hn::IfThenElse(is_odd, hn::NegMulAdd(twice, sine, hn::Set(d, 2.0)), hn::Mul(twice, sine)),
          hn::IfThenElse(is_odd, hn::Neg(mixed), mixed)};
}

// Beyond the range of that reduction.
HWY_NOINLINE Products products_far(Numbers angle) {
  const Lanes d;
  HWY_ALIGN std::array<double, kColumnStep> angles{}, square{}, mixed{};
  hn::Store(angle, d, angles.data());
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    const double sine = std::sin(angles[i]);
    square[i] = 2.0 * sine * sine;
    mixed[i] = 2.0 * sine * std::cos(angles[i]);
  }
  return {hn::Load(d, square.data()), hn::Load(d, mixed.data())};
}

HWY_INLINE Turn turn(const double* decay, const double* half_frequency, Numbers s, bool is_far) {
  const Lanes d;
  const Numbers half = hn::Mul(hn::LoadU(d, half_frequency), s);
  const Products products = HWY_UNLIKELY(is_far) ? products_far(half) : products_near(half);
  const Numbers lost = hn::Expm1(d, hn::Neg(hn::Mul(hn::LoadU(d, decay), s)));
  const Numbers left = hn::Add(hn::Set(d, 1.0), lost);
  return {hn::NegMulAdd(left, products.square, lost), hn::Mul(left, products.mixed), left};
}

HWY_INLINE double sum_of(Numbers numbers) {
  const Lanes d;
  return hn::GetLane(hn::SumOfLanes(d, numbers));
}

void sum_terms(const TermColumns& terms, double at, int m, TermSums& sums,
               const TermShareColumns& shares) {
  const Lanes d;
  const Numbers s = hn::Set(d, at), one = hn::Set(d, 1.0);
  const Numbers values = hn::Set(d, m == 0 ? 0.0 : 1.0);
  const bool is_far = terms.quickest * at > kFarthestHalfAngle;
  Numbers value = hn::Zero(d), slope = value, curvature = value, bound = value, third = value,
          rounding = value;
  for (std::size_t i = 0; i < terms.count; i += hn::Lanes(d)) {
    const Turn t = at == 0.0 ? Turn{hn::Zero(d), hn::Zero(d), one}
                             : turn(terms.decay + i, terms.half_frequency + i, s, is_far);
    const Numbers decay = hn::LoadU(d, terms.decay + i);
    const Numbers half = hn::LoadU(d, terms.half_frequency + i), frequency = hn::Add(half, half);
    const Numbers rate_size = hn::LoadU(d, terms.rate_size + i);
    Numbers re = hn::LoadU(d, terms.re + i), im = hn::LoadU(d, terms.im + i);
    Numbers size = hn::Mul(t.decay, hn::LoadU(d, terms.size + i));
    Numbers largest = hn::LoadU(d, terms.rounded + i);
    const auto derive = [&](Numbers& a, Numbers& b) {  // times l
      const Numbers derived = hn::Neg(hn::MulAdd(a, decay, hn::Mul(b, frequency)));
      b = hn::MulSub(a, frequency, hn::Mul(b, decay));
      a = derived;
    };
    for (int k = 0; k < m; ++k) {
      derive(re, im);
      size = hn::Mul(size, rate_size);
      largest = hn::Mul(largest, rate_size);
    }
    const Numbers grown = hn::Add(one, t.re_minus_one);
    const Numbers change = hn::MulSub(re, t.re_minus_one, hn::Mul(im, t.im));
    const Numbers own = hn::MulSub(re, grown, hn::Mul(im, t.im));
    value = hn::Add(value, m == 0 ? change : own);
    derive(re, im);
    const Numbers own_slope = hn::MulSub(re, grown, hn::Mul(im, t.im));
    derive(re, im);
    const Numbers own_curvature = hn::MulSub(re, grown, hn::Mul(im, t.im));
    const Numbers own_bound = hn::Mul(hn::Mul(size, rate_size), rate_size);
    const Numbers own_third = hn::Mul(own_bound, rate_size);
    slope = hn::Add(slope, own_slope);
    curvature = hn::Add(curvature, own_curvature);
    bound = hn::Add(bound, own_bound);
    third = hn::Add(third, own_third);
    rounding = hn::MulAdd(largest, hn::MulAdd(s, rate_size, hn::Mul(values, t.decay)), rounding);
    if (!shares.slope) continue;
    hn::StoreU(own_slope, d, shares.slope + i);
    hn::StoreU(own_curvature, d, shares.curvature + i);
    hn::StoreU(own_third, d, shares.third + i);
    hn::StoreU(hn::Add(own, size), d, shares.fall + i);
  }
  sums = {sum_of(value), sum_of(slope), sum_of(curvature),
          sum_of(bound), sum_of(third), sum_of(rounding)};
}

void turn_terms(const double* decay, const double* half_frequency, std::size_t count,
                double quickest, double at, double* re_minus_one, double* im) {
  const Lanes d;
  const Numbers s = hn::Set(d, at);
  const bool is_far = quickest * at > kFarthestHalfAngle;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Turn t = turn(decay + i, half_frequency + i, s, is_far);
    hn::StoreU(t.re_minus_one, d, re_minus_one + i);
    hn::StoreU(t.im, d, im + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace graze
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze {
namespace {

HWY_EXPORT(sum_terms);
HWY_EXPORT(turn_terms);

}  // namespace

void sum_terms(const TermColumns& terms, double s, int m, TermSums& sums,
               const TermShareColumns& shares) {
  HWY_DYNAMIC_DISPATCH(sum_terms)(terms, s, m, sums, shares);
}

void turn_terms(const double* decay, const double* half_frequency, std::size_t count,
                double quickest, double s, double* re_minus_one, double* im) {
  HWY_DYNAMIC_DISPATCH(turn_terms)
  (decay, half_frequency, count, quickest, s, re_minus_one, im);
}

}  // namespace graze
#endif
