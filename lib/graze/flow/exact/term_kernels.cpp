#include "graze/flow/exact/detail/term_kernels.hpp"

// This file is compiled once for every vector unit.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/flow/exact/term_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "graze/flow/exact/detail/turns-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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
