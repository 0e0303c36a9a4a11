// e^{l s} - 1 of vectors of numbers, for kernels that are compiled once for every vector unit: to
// be included after <hwy/foreach_target.h>.
#include <hwy/highway.h>

#include <array>
#include <cmath>

#include "graze/flow/exact/detail/vector_columns.hpp"

#if defined(GRAZE_FLOW_EXACT_DETAIL_TURNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_FLOW_EXACT_DETAIL_TURNS_INL_HPP
#undef GRAZE_FLOW_EXACT_DETAIL_TURNS_INL_HPP
#else
#define GRAZE_FLOW_EXACT_DETAIL_TURNS_INL_HPP
#endif

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

// Adding it to a number rounds that to an integer, whose lowest bits are then those of the sum.
inline constexpr double kToInteger = 0x1.8p52;

// e^x - 1, within two units of the last place; -1 and infinity beyond the range of e^x. e^x is 2^n
// (1 + p), where p is Taylor's series up to r^13 for |r| <= (log 2)/2, with an error below 2e-17.
// The library's own function takes half as many operations again.
HWY_INLINE Numbers expm1(Numbers x) {
  static constexpr std::array<double, 8> kLow = {1.0 / 2,   1.0 / 6,    1.0 / 24,    1.0 / 120,
                                                 1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880};
  const Lanes d;
  const hn::RebindToSigned<Lanes> bits;
  x = hn::Min(hn::Max(x, hn::Set(d, -708.0)), hn::Set(d, 710.0));
  const Numbers integer = hn::Set(d, kToInteger + 1023.0);  // and the exponent of 2^n
  const Numbers marked = hn::MulAdd(x, hn::Set(d, 0x1.71547652b82fep0), integer);
  const Numbers n = hn::Sub(marked, integer);
  // log 2 in two parts, the first so short that its multiples are exact.
  Numbers r = hn::NegMulAdd(n, hn::Set(d, 0x1.62e42feep-1), x);
  r = hn::NegMulAdd(n, hn::Set(d, 0x1.a39ef35793c76p-33), r);
  const Numbers r2 = hn::Mul(r, r), r4 = hn::Mul(r2, r2);
  const Numbers tenth = hn::MulAdd(r, hn::Set(d, 1.0 / 39916800), hn::Set(d, 1.0 / 3628800));
  const Numbers last = hn::MulAdd(r, hn::Set(d, 1.0 / 6227020800), hn::Set(d, 1.0 / 479001600));
  const Numbers high = hn::MulAdd(last, r2, tenth);
  const Numbers p = hn::MulAdd(hn::MulAdd(high, hn::Mul(r4, r4), series(r, kLow)), r2, r);
  const Numbers power = hn::BitCast(d, hn::ShiftLeft<52>(hn::BitCast(bits, marked)));
  return hn::MulAdd(p, power, hn::Sub(power, hn::Set(d, 1.0)));
}

// For an angle: 2 sin^2 and 2 sin cos, both of period pi.
struct Products {
  Numbers square, mixed;
};

// The angle less the nearest multiple of pi/2 is at most pi/4, where Taylor's series up to r^17 and
// r^16 leave less than 1e-19 and 3e-18; an odd multiple exchanges sine and cosine. The library's
// functions reduce the angle to pi/2 only, so that the rounding of the coefficients shows: sin^2 +
// cos^2 misses 1 by 4e-17 on the average, which adds up in the energy of 1e6 arcs.
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

// For angles beyond the range of that reduction.
inline HWY_NOINLINE Products products_far(Numbers angle) {
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
  const Numbers lost = expm1(hn::Neg(hn::Mul(hn::LoadU(d, decay), s)));
  const Numbers left = hn::Add(hn::Set(d, 1.0), lost);
  return {hn::NegMulAdd(left, products.square, lost), hn::Mul(left, products.mixed), left};
}

}  // namespace HWY_NAMESPACE
}  // namespace graze
HWY_AFTER_NAMESPACE();

#endif
