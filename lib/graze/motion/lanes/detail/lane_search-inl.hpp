// The search for the first contact, one evaluation of all gaps at a time, of a vector of lanes:
// steps by the same kind of bounds as in first_zero.hpp. To be included after
// <hwy/foreach_target.h>.
#include <hwy/highway.h>

#include <limits>

#include "graze/flow/exact/detail/curve_terms.hpp"
#include "graze/flow/exact/detail/turns-inl.hpp"
#include "graze/motion/lanes/detail/lane_columns.hpp"

#if defined(GRAZE_MOTION_LANES_DETAIL_LANE_SEARCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_MOTION_LANES_DETAIL_LANE_SEARCH_INL_HPP
#undef GRAZE_MOTION_LANES_DETAIL_LANE_SEARCH_INL_HPP
#else
#define GRAZE_MOTION_LANES_DETAIL_LANE_SEARCH_INL_HPP
#endif

HWY_BEFORE_NAMESPACE();
namespace graze {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Chosen = hn::Mask<Lanes>;

inline constexpr double kEps = std::numeric_limits<double>::epsilon();
// A flight that takes more looks is near a grazing; the lane is then left to the caller.
inline constexpr double kMostLooks = 512.0;
// Number of stretches that cubic_step() tries: a third would cost more than it saves.
inline constexpr int kTries = 2;

HWY_INLINE Numbers number(double value) { return hn::Set(Lanes(), value); }
HWY_INLINE Numbers unbounded() { return number(std::numeric_limits<double>::infinity()); }

// The lanes of one vector, from `first` on.
struct LaneVector {
  const LaneColumns* columns;
  std::size_t first;

  HWY_INLINE Numbers load(const double* row) const { return hn::Load(Lanes(), row + first); }
  HWY_INLINE void keep(double* row, Numbers numbers) const {
    hn::Store(numbers, Lanes(), row + first);
  }
  HWY_INLINE void keep(double* row, Chosen chosen, Numbers numbers) const {
    hn::Store(hn::IfThenElse(chosen, numbers, load(row)), Lanes(), row + first);
  }
  template <class... Place>
  HWY_INLINE Numbers get(Place... place) const {
    return load(columns->row(place...));
  }
  HWY_INLINE Chosen is_at(LaneStage stage) const {
    return hn::Eq(get(LaneRow::kStage), number(static_cast<double>(stage)));
  }
};

// e^{l s} - 1 of forcing and modes at `at`.
HWY_INLINE void turn_lanes(const LaneVector& lanes) {
  const LaneColumns& c = *lanes.columns;
  const Numbers s = lanes.get(LaneRow::kAt);
  for (std::size_t k = 0; k < c.harmonics(); ++k) {
    const Products forcing =
        products_near(hn::Mul(lanes.get(LaneHarmonicRow::kHalfFrequency, k), s));
    lanes.keep(c.row(LaneHarmonicRow::kTurnRe, k), hn::Neg(forcing.square));
    lanes.keep(c.row(LaneHarmonicRow::kTurnIm, k), forcing.mixed);
  }
  for (std::size_t j = 0; j < c.modes(); ++j) {
    const Turn t = turn(c.row(LaneModeRow::kDecay, j) + lanes.first,
                        c.row(LaneModeRow::kHalfFrequency, j) + lanes.first, s, false);
    lanes.keep(c.row(LaneModeRow::kTurnRe, j), t.re_minus_one);
    lanes.keep(c.row(LaneModeRow::kTurnIm, j), t.im);
    lanes.keep(c.row(LaneModeRow::kTurnDecay, j), t.decay);
  }
}

// Sums over the terms of a gap at `at`; see CurvePoint.
struct LanePoint {
  Numbers value, slope, curvature, bound, third, noise;
};

// Adds harmonic k of the forcing to the gap at stop i.
HWY_INLINE void add_harmonic(const LaneVector& lanes, std::size_t i, std::size_t k,
                             LanePoint& point) {
  const Numbers s = lanes.get(LaneRow::kAt), half = lanes.get(LaneHarmonicRow::kHalfFrequency, k);
  const Numbers frequency = hn::Add(half, half), square = hn::Mul(frequency, frequency);
  const Numbers re = lanes.get(LaneGapRow::kForcedRe, i, k);
  const Numbers im = lanes.get(LaneGapRow::kForcedIm, i, k);
  const Numbers lost = lanes.get(LaneHarmonicRow::kTurnRe, k);
  const Numbers grown = hn::Add(number(1.0), lost);
  const Numbers turned = lanes.get(LaneHarmonicRow::kTurnIm, k);
  const Numbers size = lanes.get(LaneGapRow::kSize, i, k), bound = hn::Mul(size, square);
  const Numbers across = hn::MulAdd(im, grown, hn::Mul(re, turned));
  const Numbers own = hn::MulSub(re, grown, hn::Mul(im, turned));
  point.value = hn::Add(point.value, hn::MulSub(re, lost, hn::Mul(im, turned)));
  point.slope = hn::NegMulAdd(frequency, across, point.slope);
  point.curvature = hn::NegMulAdd(square, own, point.curvature);
  point.bound = hn::Add(point.bound, bound);
  point.third = hn::MulAdd(bound, frequency, point.third);
  point.noise = hn::MulAdd(size, hn::Mul(s, frequency), point.noise);
}

// The forcing's part of the gap at stop i.
HWY_INLINE LanePoint forced_point(const LaneVector& lanes, std::size_t i) {
  const LaneColumns& c = *lanes.columns;
  const Numbers zero = number(0.0);
  LanePoint point{zero, zero, zero, zero, zero, zero};
  for (std::size_t k = 0; k < c.harmonics(); ++k) add_harmonic(lanes, i, k, point);
  lanes.keep(c.row(LaneStopRow::kForcedSlope, i), point.slope);
  lanes.keep(c.row(LaneStopRow::kForcedCurvature, i), point.curvature);
  lanes.keep(c.row(LaneStopRow::kForcedThird, i), point.third);
  return point;
}

// Adds mode j to the gap at stop i.
HWY_INLINE void add_mode(const LaneVector& lanes, std::size_t i, std::size_t j, LanePoint& point) {
  const LaneColumns& c = *lanes.columns;
  const Numbers re = lanes.get(LaneModeRow::kAmplitude, j);
  const Numbers im = lanes.get(LaneModeRow::kAmplitudeIm, j);
  const Numbers lost = lanes.get(LaneModeRow::kTurnRe, j);
  const Numbers grown = hn::Add(number(1.0), lost), turned = lanes.get(LaneModeRow::kTurnIm, j);
  const Numbers decay = lanes.get(LaneModeRow::kDecay, j), rate = lanes.get(LaneModeRow::kRate, j);
  const Numbers half = lanes.get(LaneModeRow::kHalfFrequency, j), frequency = hn::Add(half, half);
  const Numbers row = lanes.get(LanePairRow::kRow, i, j), weight = hn::Abs(row);
  const Numbers change = hn::MulSub(re, lost, hn::Mul(im, turned));
  const Numbers own = hn::MulSub(re, grown, hn::Mul(im, turned));
  const Numbers across = hn::MulAdd(re, turned, hn::Mul(im, grown));
  // Derivatives of y = Re(Z e^{l s}) with y'' = -2 delta y' - w^2 y.
  const Numbers slope = hn::Neg(hn::MulAdd(decay, own, hn::Mul(frequency, across)));
  const Numbers square = hn::Mul(rate, rate);
  const Numbers curvature = hn::Neg(hn::MulAdd(hn::Add(decay, decay), slope, hn::Mul(square, own)));
  const Numbers size = lanes.get(LaneModeRow::kSize, j);
  const Numbers left = hn::Mul(weight, hn::Mul(size, lanes.get(LaneModeRow::kTurnDecay, j)));
  const Numbers bound = hn::Mul(left, square);
  point.value = hn::NegMulAdd(row, change, point.value);
  point.slope = hn::NegMulAdd(row, slope, point.slope);
  point.curvature = hn::NegMulAdd(row, curvature, point.curvature);
  point.bound = hn::Add(point.bound, bound);
  point.third = hn::MulAdd(bound, rate, point.third);
  point.noise = hn::MulAdd(hn::MulAdd(size, weight, lanes.get(LanePairRow::kFormedFrom, i, j)),
                           hn::Mul(lanes.get(LaneRow::kAt), rate), point.noise);
  lanes.keep(c.row(LanePairRow::kFall, i, j), hn::NegMulAdd(row, own, left));
  lanes.keep(c.row(LanePairRow::kSlowSlope, i, j), point.slope);
  lanes.keep(c.row(LanePairRow::kSlowCurvature, i, j), point.curvature);
  lanes.keep(c.row(LanePairRow::kSlowThird, i, j), point.third);
}

// The gap at stop i and its derivatives at `at`.
HWY_INLINE void find_point(const LaneVector& lanes, std::size_t i) {
  const LaneColumns& c = *lanes.columns;
  LanePoint point = forced_point(lanes, i);
  for (std::size_t j = 0; j < c.modes(); ++j) add_mode(lanes, i, j, point);
  lanes.keep(c.row(LaneStopRow::kValue, i),
             hn::Add(point.value, lanes.get(LaneStopRow::kStartValue, i)));
  lanes.keep(c.row(LaneStopRow::kSlope, i), point.slope);
  lanes.keep(c.row(LaneStopRow::kCurvature, i), point.curvature);
  lanes.keep(c.row(LaneStopRow::kThird, i), point.third);
  lanes.keep(c.row(LaneStopRow::kBound, i), point.bound);
  lanes.keep(c.row(LaneStopRow::kNoise, i), hn::MulAdd(point.noise, number(kTermRoundings * kEps),
                                                       lanes.get(LaneStopRow::kStartNoise, i)));
}

// As parabola_step() of first_zero.hpp; infinite where there is no limit. Zero, so that the lane
// leaves, where squares are out of the range of the numbers.
HWY_INLINE Numbers parabola_step(Numbers value, Numbers slope, Numbers bound) {
  const Numbers zero = number(0.0);
  const Numbers square = hn::Mul(slope, slope), twice = hn::Mul(hn::Add(value, value), bound);
  const Numbers whole = hn::Add(square, twice);
  const Numbers root = hn::Sqrt(hn::Max(whole, zero));
  const Chosen falls = hn::Lt(slope, zero);
  const Numbers above = hn::IfThenElse(falls, hn::Add(value, value), hn::Add(slope, root));
  const Numbers below = hn::IfThenElse(falls, hn::Sub(root, slope), bound);
  const Chosen never = hn::Or(hn::Lt(whole, zero), hn::AndNot(falls, hn::Le(bound, zero)));
  const Numbers least = number(std::numeric_limits<double>::min());
  const Chosen in_range = hn::And(hn::Or(hn::Gt(square, least), hn::Gt(hn::Abs(twice), least)),
                                  hn::Lt(hn::Abs(whole), unbounded()));
  return hn::IfThenElseZero(in_range, hn::IfThenElse(never, unbounded(), hn::Div(above, below)));
}

// Derivatives of a gap by its slow terms alone, and a bound on the third.
struct SlowTerms {
  Numbers slope, curvature, third;
};
HWY_INLINE SlowTerms slow_terms(const LaneVector& lanes, std::size_t i, std::size_t mode) {
  return {lanes.get(LanePairRow::kSlowSlope, i, mode),
          lanes.get(LanePairRow::kSlowCurvature, i, mode),
          lanes.get(LanePairRow::kSlowThird, i, mode)};
}
HWY_INLINE SlowTerms forced_terms(const LaneVector& lanes, std::size_t i) {
  return {lanes.get(LaneStopRow::kForcedSlope, i), lanes.get(LaneStopRow::kForcedCurvature, i),
          lanes.get(LaneStopRow::kForcedThird, i)};
}

// As cubic_step() of first_zero.hpp, and also from a stop that is left.
HWY_INLINE Numbers cubic_step(Numbers clear, const SlowTerms& slow, Numbers first) {
  const Numbers rise = hn::Mul(slow.third, number(1.0 / 3.0));
  Numbers h = first, best = number(0.0);
  for (int i = 0; i < kTries; ++i) {
    const Numbers step = parabola_step(clear, slow.slope, hn::MulSub(rise, h, slow.curvature));
    best = hn::Max(best, hn::IfThenElse(hn::Ge(step, number(0.0)), hn::Min(h, step), best));
    h = hn::IfThenElse(hn::Lt(step, hn::Mul(number(7.0), h)),
                       hn::Mul(number(0.5), hn::Add(h, step)), hn::Mul(number(4.0), h));
  }
  // A gap of zero counts only where it opens.
  const Chosen opens = hn::And(hn::Ge(clear, number(0.0)), hn::Gt(slow.slope, number(0.0)));
  return hn::IfThenElseZero(hn::Or(hn::Gt(clear, number(0.0)), opens), best);
}

// How far the gap at stop i, now `clear`, is certain to stay open; by its slow terms if the fast
// ones cannot take away more than half of it.
HWY_INLINE Numbers clear_step(const LaneVector& lanes, std::size_t i, Numbers clear) {
  const std::size_t modes = lanes.columns->modes();
  const Numbers most = hn::Mul(lanes.get(LaneStopRow::kValue, i), number(0.5));
  const Numbers slope = lanes.get(LaneStopRow::kSlope, i);
  SlowTerms slow{slope, lanes.get(LaneStopRow::kCurvature, i), lanes.get(LaneStopRow::kThird, i)};
  Numbers fall = number(0.0);
  Chosen open = hn::Eq(fall, fall);
  for (std::size_t k = modes; k-- > 0;) {
    const Numbers next = hn::Add(fall, lanes.get(LanePairRow::kFall, i, k));
    open = hn::And(open, hn::Le(next, most));
    if (hn::AllFalse(Lanes(), open)) break;
    fall = hn::IfThenElse(open, next, fall);
    const SlowTerms fewer = k > 0 ? slow_terms(lanes, i, k - 1) : forced_terms(lanes, i);
    slow.slope = hn::IfThenElse(open, fewer.slope, slow.slope);
    slow.curvature = hn::IfThenElse(open, fewer.curvature, slow.curvature);
    slow.third = hn::IfThenElse(open, fewer.third, slow.third);
  }
  const Numbers whole = parabola_step(clear, slope, lanes.get(LaneStopRow::kBound, i));
  const Numbers told = cubic_step(hn::Sub(clear, fall), slow, hn::Add(whole, whole));
  const Chosen ends = hn::Lt(whole, unbounded());
  const Numbers step = hn::IfThenElse(ends, hn::Max(whole, told), whole);
  return hn::IfThenElseZero(hn::Ge(step, number(0.0)), step);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze
HWY_AFTER_NAMESPACE();

#endif
