// The ends of the flights of a vector of lanes: the state there, the impact, and the start of the
// next flight. To be included after <hwy/foreach_target.h>.
#include <hwy/highway.h>

#include "graze/motion/lanes/detail/lane_search-inl.hpp"

#if defined(GRAZE_MOTION_LANES_DETAIL_LANE_ARRIVAL_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_MOTION_LANES_DETAIL_LANE_ARRIVAL_INL_HPP
#undef GRAZE_MOTION_LANES_DETAIL_LANE_ARRIVAL_INL_HPP
#else
#define GRAZE_MOTION_LANES_DETAIL_LANE_ARRIVAL_INL_HPP
#endif

HWY_BEFORE_NAMESPACE();
namespace graze {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Quantities this many times above their rounding are decided here; for others the lane is left to
// the motion that looks closely.
inline constexpr double kClearlyAbove = 64.0;

HWY_INLINE Chosen is_stop(Numbers hit, std::size_t i) {
  return hn::Eq(hit, number(static_cast<double>(i)));
}

// Row b or direction d of the stop that is hit.
HWY_INLINE Numbers of_hit(const LaneVector& lanes, LanePairRow what, Numbers hit, std::size_t j) {
  Numbers found = lanes.get(what, 0, j);
  for (std::size_t i = 1; i < lanes.columns->stops(); ++i)
    found = hn::IfThenElse(is_stop(hit, i), lanes.get(what, i, j), found);
  return found;
}
HWY_INLINE Numbers of_hit(const LaneVector& lanes, LaneStopRow what, Numbers hit) {
  Numbers found = lanes.get(what, 0);
  for (std::size_t i = 1; i < lanes.columns->stops(); ++i)
    found = hn::IfThenElse(is_stop(hit, i), lanes.get(what, i), found);
  return found;
}

// The forced part of a mode, where the harmonics have these cosines and sines, and how fast it
// falls.
struct ForcedState {
  Numbers value, fall;
};
HWY_INLINE ForcedState forced_state(const LaneVector& lanes, std::size_t j, LaneHarmonicRow cosines,
                                    LaneHarmonicRow sines) {
  ForcedState forced{number(0.0), number(0.0)};
  for (std::size_t k = 0; k < lanes.columns->harmonics(); ++k) {
    const Numbers half = lanes.get(LaneHarmonicRow::kHalfFrequency, k);
    const Numbers p_re = lanes.get(LaneAnswerRow::kRe, j, k);
    const Numbers p_im = lanes.get(LaneAnswerRow::kIm, j, k);
    const Numbers cosine = lanes.get(cosines, k), sine = lanes.get(sines, k);
    forced.value = hn::Add(forced.value, hn::MulSub(p_re, cosine, hn::Mul(p_im, sine)));
    forced.fall =
        hn::MulAdd(hn::Add(half, half), hn::MulAdd(p_re, sine, hn::Mul(p_im, cosine)), forced.fall);
  }
  return forced;
}

// Displacements and velocities at `at`; returns the lanes where they are finite.
HWY_INLINE Chosen end_flight(const LaneVector& lanes, Chosen arrived) {
  const LaneColumns& c = *lanes.columns;
  for (std::size_t k = 0; k < c.harmonics(); ++k) {
    const Numbers c0 = lanes.get(LaneHarmonicRow::kCosine, k);
    const Numbers n0 = lanes.get(LaneHarmonicRow::kSine, k);
    const Numbers lost = lanes.get(LaneHarmonicRow::kTurnRe, k);
    const Numbers turned = lanes.get(LaneHarmonicRow::kTurnIm, k);
    lanes.keep(c.row(LaneHarmonicRow::kEndCosine, k),
               hn::Add(c0, hn::MulSub(c0, lost, hn::Mul(n0, turned))));
    lanes.keep(c.row(LaneHarmonicRow::kEndSine, k),
               hn::Add(n0, hn::MulAdd(c0, turned, hn::Mul(n0, lost))));
  }
  Chosen finite = arrived;
  for (std::size_t j = 0; j < c.modes(); ++j) {
    const Numbers re = lanes.get(LaneModeRow::kAmplitude, j);
    const Numbers im = lanes.get(LaneModeRow::kAmplitudeIm, j);
    const Numbers t_re = lanes.get(LaneModeRow::kTurnRe, j),
                  t_im = lanes.get(LaneModeRow::kTurnIm, j);
    const Numbers y = hn::Add(re, hn::MulSub(re, t_re, hn::Mul(im, t_im)));
    const Numbers across = hn::Add(im, hn::MulAdd(re, t_im, hn::Mul(im, t_re)));
    const Numbers half_own = lanes.get(LaneModeRow::kHalfFrequency, j);
    const ForcedState forced =
        forced_state(lanes, j, LaneHarmonicRow::kEndCosine, LaneHarmonicRow::kEndSine);
    const Numbers q = hn::Add(hn::Add(y, lanes.get(LaneModeRow::kOffset, j)), forced.value);
    const Numbers free_rate = hn::MulAdd(lanes.get(LaneModeRow::kDecay, j), y,
                                         hn::Mul(hn::Add(half_own, half_own), across));
    const Numbers qdot = hn::Neg(hn::Add(free_rate, forced.fall));
    lanes.keep(c.row(LaneModeRow::kEnd, j), arrived, q);
    lanes.keep(c.row(LaneModeRow::kEndRate, j), arrived, qdot);
    lanes.keep(c.row(LaneModeRow::kAfterRate, j), arrived, qdot);
    const Numbers size = hn::Add(hn::Abs(q), hn::Abs(qdot));
    finite = hn::And(finite, hn::Lt(size, unbounded()));
  }
  return finite;
}

// row.q = gap holds where the stop is hit: Motion::settle_on.
HWY_INLINE void settle_lanes(const LaneVector& lanes, Chosen contact, Numbers hit) {
  const LaneColumns& c = *lanes.columns;
  const Numbers flight = lanes.get(LaneRow::kAt);
  Numbers largest = number(0.0), reach = largest, whole = largest;
  for (std::size_t j = 0; j < c.modes(); ++j) {
    const Numbers q = lanes.get(LaneModeRow::kEnd, j), qdot = lanes.get(LaneModeRow::kEndRate, j);
    const Numbers time = hn::Min(flight, lanes.get(LaneModeRow::kPerRate, j));
    const Numbers moves = hn::MulAdd(hn::Abs(qdot), time, hn::Abs(q));
    lanes.keep(c.row(LaneModeRow::kShare, j), moves);
    largest = hn::Max(largest, moves);
    reach = hn::MulAdd(of_hit(lanes, LanePairRow::kRow, hit, j), q, reach);
  }
  const Numbers per_largest = hn::Div(number(1.0), largest);
  for (std::size_t j = 0; j < c.modes(); ++j) {
    const Numbers part = hn::Mul(lanes.get(LaneModeRow::kShare, j), per_largest);
    const Numbers row = of_hit(lanes, LanePairRow::kRow, hit, j);
    const Numbers share = hn::Mul(row, hn::Mul(part, part));
    lanes.keep(c.row(LaneModeRow::kShare, j), share);
    whole = hn::MulAdd(row, share, whole);
  }
  const Numbers offset = hn::Div(hn::Sub(of_hit(lanes, LaneStopRow::kGap, hit), reach), whole);
  for (std::size_t j = 0; j < c.modes(); ++j)
    lanes.keep(
        c.row(LaneModeRow::kEnd, j), contact,
        hn::MulAdd(offset, lanes.get(LaneModeRow::kShare, j), lanes.get(LaneModeRow::kEnd, j)));
}

// Sums over the modes of |b q|, |b q'| and of the sizes of what pushes at a stop.
struct LaneSizes {
  Numbers reach, speed, push;
};
HWY_INLINE LaneSizes sizes_at(const LaneVector& lanes, std::size_t i) {
  LaneSizes sizes{number(0.0), number(0.0), number(0.0)};
  for (std::size_t j = 0; j < lanes.columns->modes(); ++j) {
    const Numbers row = hn::Abs(lanes.get(LanePairRow::kRow, i, j));
    const Numbers q = hn::Abs(lanes.get(LaneModeRow::kEnd, j));
    const Numbers qdot = hn::Abs(lanes.get(LaneModeRow::kEndRate, j));
    const Numbers rate = lanes.get(LaneModeRow::kRate, j),
                  decay = lanes.get(LaneModeRow::kDecay, j);
    const Numbers away = hn::Add(q, hn::Abs(lanes.get(LaneModeRow::kOffset, j)));
    const Numbers damping = hn::Mul(hn::Add(decay, decay), qdot);
    const Numbers push = hn::Add(hn::Abs(lanes.get(LaneModeRow::kForce, j)),
                                 hn::MulAdd(hn::Mul(rate, rate), away, damping));
    sizes.reach = hn::MulAdd(row, q, sizes.reach);
    sizes.speed = hn::MulAdd(row, qdot, sizes.speed);
    sizes.push = hn::MulAdd(row, push, sizes.push);
  }
  return sizes;
}

// Whether stop i has no part in the contact (unless it is the one that is hit), nor in a chatter
// between several stops.
HWY_INLINE Chosen is_apart(const LaneVector& lanes, std::size_t i, const LaneSizes& sizes,
                           Numbers hit, Numbers speed, Numbers time) {
  const LaneColumns& c = *lanes.columns;
  const Numbers eps = number(kClearlyAbove * kEps * static_cast<double>(c.modes() + 2));
  const Numbers gap = lanes.get(LaneStopRow::kGap, i);
  Numbers open = gap;
  for (std::size_t j = 0; j < c.modes(); ++j)
    open = hn::NegMulAdd(lanes.get(LanePairRow::kRow, i, j), lanes.get(LaneModeRow::kEnd, j), open);
  const Numbers rounding = hn::Mul(eps, hn::Add(hn::Abs(gap), sizes.reach));
  const Numbers near = hn::MulAdd(hn::Mul(eps, time), sizes.speed, rounding);
  return hn::And(hn::Or(is_stop(hit, i), hn::Gt(open, near)),
                 hn::Gt(hn::Mul(speed, speed), hn::Mul(sizes.push, rounding)));
}

// Impacts on single stops; returns those that were decided.
HWY_INLINE Chosen hit_stops(const LaneVector& lanes, Chosen contact) {
  const LaneColumns& c = *lanes.columns;
  const Numbers hit = lanes.get(LaneRow::kHit);
  settle_lanes(lanes, contact, hit);
  Numbers speed = number(0.0), size = speed, push = speed;
  for (std::size_t j = 0; j < c.modes(); ++j)
    speed = hn::MulAdd(of_hit(lanes, LanePairRow::kRow, hit, j),
                       lanes.get(LaneModeRow::kEndRate, j), speed);
  const Numbers time = hn::Add(lanes.get(LaneRow::kLocal), lanes.get(LaneRow::kAt));
  Chosen decided = hn::And(contact, hn::Gt(speed, lanes.get(LaneRow::kSlowest)));
  for (std::size_t i = 0; i < c.stops(); ++i) {
    const LaneSizes sizes = sizes_at(lanes, i);
    size = hn::Max(size, sizes.speed);
    push = hn::Max(push, sizes.push);
    if (c.stops() > 1) decided = hn::And(decided, is_apart(lanes, i, sizes, hit, speed, time));
  }
  const Numbers target = hn::Neg(hn::Mul(of_hit(lanes, LaneStopRow::kRestitution, hit), speed));
  const Numbers norm = of_hit(lanes, LaneStopRow::kNorm, hit);
  // Two passes, as in Motion::impact_alone.
  for (int pass = 0; pass < 2; ++pass) {
    Numbers impulse = hn::Neg(target);
    for (std::size_t j = 0; j < c.modes(); ++j)
      impulse = hn::MulAdd(of_hit(lanes, LanePairRow::kRow, hit, j),
                           lanes.get(LaneModeRow::kAfterRate, j), impulse);
    impulse = hn::Div(impulse, norm);
    for (std::size_t j = 0; j < c.modes(); ++j)
      lanes.keep(c.row(LaneModeRow::kAfterRate, j), contact,
                 hn::NegMulAdd(impulse, of_hit(lanes, LanePairRow::kDirection, hit, j),
                               lanes.get(LaneModeRow::kAfterRate, j)));
  }
  lanes.keep(c.row(LaneRow::kSpeed), contact, speed);
  const Numbers rounding = hn::Mul(number(kClearlyAbove * kEps), hn::MulAdd(time, push, size));
  decided = hn::And(decided, hn::Gt(hn::Neg(target), rounding));
  return hn::And(decided, hn::Lt(time, lanes.get(LaneRow::kPeriod)));
}

// The gaps at the start of the flight that begins in kEnd, kAfterRate.
HWY_INLINE void begin_gaps(const LaneVector& lanes, Chosen chosen, Chosen contact) {
  const LaneColumns& c = *lanes.columns;
  const Numbers hit = lanes.get(LaneRow::kHit), zero = number(0.0);
  for (std::size_t i = 0; i < c.stops(); ++i) {
    for (std::size_t k = 0; k < c.harmonics(); ++k) {
      const Numbers re = lanes.get(LaneGapRow::kRe, i, k), im = lanes.get(LaneGapRow::kIm, i, k);
      const Numbers cosine = lanes.get(LaneHarmonicRow::kCosine, k);
      const Numbers sine = lanes.get(LaneHarmonicRow::kSine, k);
      lanes.keep(c.row(LaneGapRow::kForcedRe, i, k), chosen,
                 hn::MulSub(re, cosine, hn::Mul(im, sine)));
      lanes.keep(c.row(LaneGapRow::kForcedIm, i, k), chosen,
                 hn::MulAdd(re, sine, hn::Mul(im, cosine)));
    }
    const Numbers gap = lanes.get(LaneStopRow::kGap, i);
    Numbers reach = zero, size = hn::Abs(gap);
    for (std::size_t j = 0; j < c.modes(); ++j) {
      const Numbers part =
          hn::Mul(lanes.get(LanePairRow::kRow, i, j), lanes.get(LaneModeRow::kEnd, j));
      reach = hn::Add(reach, part);
      size = hn::Add(size, hn::Abs(part));
    }
    const Chosen from = hn::And(contact, is_stop(hit, i));
    const Numbers noise = hn::Mul(number(static_cast<double>(c.modes() + 2) * kEps), size);
    lanes.keep(c.row(LaneStopRow::kStartValue, i), chosen,
               hn::IfThenElse(from, zero, hn::Sub(gap, reach)));
    lanes.keep(c.row(LaneStopRow::kStartNoise, i), chosen, hn::IfThenElse(from, zero, noise));
    lanes.keep(c.row(LaneStopRow::kClearUntil, i), chosen, zero);
  }
}

// The next flight, from kEnd and kAfterRate, at `local` in the period.
HWY_INLINE void begin_flight(const LaneVector& lanes, Chosen chosen, Chosen contact,
                             Numbers local) {
  const LaneColumns& c = *lanes.columns;
  for (std::size_t k = 0; k < c.harmonics(); ++k) {
    const Products phase =
        products_near(hn::MulAdd(lanes.get(LaneHarmonicRow::kHalfFrequency, k), local,
                                 lanes.get(LaneHarmonicRow::kHalfPhase, k)));
    lanes.keep(c.row(LaneHarmonicRow::kCosine, k), chosen, hn::Sub(number(1.0), phase.square));
    lanes.keep(c.row(LaneHarmonicRow::kSine, k), chosen, phase.mixed);
  }
  for (std::size_t j = 0; j < c.modes(); ++j) {
    const Numbers q = lanes.get(LaneModeRow::kEnd, j), qdot = lanes.get(LaneModeRow::kAfterRate, j);
    const ForcedState forced =
        forced_state(lanes, j, LaneHarmonicRow::kCosine, LaneHarmonicRow::kSine);
    const Numbers y = hn::Sub(hn::Sub(q, lanes.get(LaneModeRow::kOffset, j)), forced.value);
    const Numbers ydot = hn::Add(qdot, forced.fall);
    const Numbers across = hn::Neg(hn::Mul(hn::MulAdd(lanes.get(LaneModeRow::kDecay, j), y, ydot),
                                           lanes.get(LaneModeRow::kPerFrequency, j)));
    const Numbers square = hn::MulAdd(y, y, hn::Mul(across, across));
    const Numbers sum = hn::Add(hn::Abs(y), hn::Abs(across));
    const Chosen in_range = hn::Gt(square, number(std::numeric_limits<double>::min()));
    lanes.keep(c.row(LaneModeRow::kAmplitude, j), chosen, y);
    lanes.keep(c.row(LaneModeRow::kAmplitudeIm, j), chosen, across);
    lanes.keep(c.row(LaneModeRow::kSize, j), chosen,
               hn::IfThenElse(in_range, hn::Sqrt(square), sum));
    lanes.keep(c.row(LaneModeRow::kStart, j), chosen, q);
    lanes.keep(c.row(LaneModeRow::kStartRate, j), chosen, qdot);
  }
  begin_gaps(lanes, chosen, contact);
  lanes.keep(c.row(LaneRow::kFrom), chosen,
             hn::IfThenElse(contact, lanes.get(LaneRow::kHit), number(-1.0)));
  lanes.keep(c.row(LaneRow::kLocal), chosen, local);
  lanes.keep(c.row(LaneRow::kWindow), chosen, hn::Sub(lanes.get(LaneRow::kPeriod), local));
  lanes.keep(c.row(LaneRow::kAt), chosen, number(0.0));
  lanes.keep(c.row(LaneRow::kLooks), chosen, number(0.0));
  lanes.keep(c.row(LaneRow::kCorrection), chosen, unbounded());
  lanes.keep(c.row(LaneRow::kStage), chosen, number(static_cast<double>(LaneStage::kSearch)));
}

}  // namespace HWY_NAMESPACE
}  // namespace graze
HWY_AFTER_NAMESPACE();

#endif
