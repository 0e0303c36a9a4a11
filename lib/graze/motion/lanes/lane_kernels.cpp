#include "graze/motion/lanes/detail/lane_kernels.hpp"

#include <array>

// This file is compiled once for every vector unit.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/motion/lanes/lane_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "graze/motion/lanes/detail/lane_arrival-inl.hpp"
#include "graze/motion/lanes/detail/lane_search-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// How long the gap at stop i is certainly open, and whether it certainly closes within kBall.
HWY_INLINE void look_at_stop(const LaneVector& lanes, std::size_t i) {
  const LaneColumns& c = *lanes.columns;
  const Numbers zero = number(0.0), s = lanes.get(LaneRow::kAt);
  const Numbers value = lanes.get(LaneStopRow::kValue, i),
                slope = lanes.get(LaneStopRow::kSlope, i);
  const Numbers bound = lanes.get(LaneStopRow::kBound, i),
                noise = lanes.get(LaneStopRow::kNoise, i);
  const Numbers down = hn::Neg(slope), size = hn::Abs(value);
  const Numbers ball = hn::Div(hn::Add(size, size), down);
  const Numbers within = hn::Min(bound, hn::MulAdd(lanes.get(LaneStopRow::kThird, i), ball,
                                                   hn::Abs(lanes.get(LaneStopRow::kCurvature, i))));
  const Chosen crosses =
      hn::And(hn::Gt(down, zero), hn::Le(hn::Mul(hn::Add(within, within), ball), down));
  const Numbers certain = hn::Max(hn::Sub(value, noise), zero);
  const Numbers known = lanes.get(LaneStopRow::kClearUntil, i);
  const Chosen lingers = hn::Lt(hn::Mul(slope, hn::Abs(slope)), hn::Mul(bound, noise));
  const Chosen near = hn::And(hn::Le(certain, zero), hn::Or(hn::Le(slope, zero), lingers));
  const Chosen doubtful = hn::AndNot(hn::Or(hn::Lt(s, known), crosses), near);
  lanes.keep(c.row(LaneStopRow::kDoubtful, i), hn::IfThenElse(doubtful, number(1.0), zero));
  lanes.keep(c.row(LaneStopRow::kBall, i), hn::IfThenElse(crosses, hn::Add(s, ball), unbounded()));
  lanes.keep(c.row(LaneStopRow::kClearUntil, i), lanes.is_at(LaneStage::kSearch),
             hn::Max(known, hn::Add(s, clear_step(lanes, i, certain))));
}

// The result of one evaluation of the gaps of a vector.
struct Look {
  Numbers until;    // s, nothing is met before
  Numbers hit;      // stop that is met first for certain
  Chosen crosses;   // where there is one
  Chosen doubtful;  // where a gap is within its rounding
};

// Where a stop is certainly met, and before any other could be.
HWY_INLINE Look look_at_all(const LaneVector& lanes, Chosen search) {
  const std::size_t stops = lanes.columns->stops();
  const Chosen none = hn::AndNot(search, search);
  Look look{unbounded(), lanes.get(LaneRow::kHit), none, none};
  for (std::size_t i = 0; i < stops; ++i) {
    look.until = hn::Min(look.until, lanes.get(LaneStopRow::kClearUntil, i));
    look.doubtful = hn::Or(
        look.doubtful, hn::And(search, hn::Gt(lanes.get(LaneStopRow::kDoubtful, i), number(0.0))));
    const Numbers ball = lanes.get(LaneStopRow::kBall, i);
    Chosen first = hn::And(search, hn::Lt(ball, unbounded()));
    for (std::size_t k = 0; k < stops; ++k)
      if (k != i) first = hn::And(first, hn::Ge(lanes.get(LaneStopRow::kClearUntil, k), ball));
    look.hit = hn::IfThenElse(first, number(static_cast<double>(i)), look.hit);
    look.crosses = hn::Or(look.crosses, first);
  }
  return look;
}

HWY_INLINE void go(const LaneVector& lanes, Chosen chosen, LaneStage stage, Numbers at) {
  lanes.keep(lanes.columns->row(LaneRow::kStage), chosen, number(static_cast<double>(stage)));
  lanes.keep(lanes.columns->row(LaneRow::kAt), chosen, at);
}

HWY_INLINE LaneSet lane_set(Chosen chosen, std::size_t first) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Lanes(), chosen, bits);
  return static_cast<LaneSet>(bits[0]) << first;
}

// These lanes go back to the start of their flight and leave.
HWY_INLINE void leave(const LaneVector& lanes, Chosen leaves, LaneArrivals& arrivals) {
  lanes.keep(lanes.columns->row(LaneRow::kStage), leaves,
             number(static_cast<double>(LaneStage::kIdle)));
  arrivals.left |= lane_set(leaves, lanes.first);
}

// A step of Halley's method towards the stop that is met.
HWY_INLINE void finish_step(const LaneVector& lanes, Chosen chosen, Chosen begins) {
  const LaneColumns& c = *lanes.columns;
  const Numbers one = number(1.0), two = number(2.0), s = lanes.get(LaneRow::kAt);
  const Numbers hit = lanes.get(LaneRow::kHit), window = lanes.get(LaneRow::kWindow);
  const Numbers value = of_hit(lanes, LaneStopRow::kValue, hit);
  const Numbers slope = of_hit(lanes, LaneStopRow::kSlope, hit);
  const Numbers curvature = of_hit(lanes, LaneStopRow::kCurvature, hit);
  const Numbers third =
      hn::IfThenElse(begins, of_hit(lanes, LaneStopRow::kThird, hit), lanes.get(LaneRow::kThird));
  const Numbers before = hn::IfThenElse(begins, unbounded(), lanes.get(LaneRow::kCorrection));
  const Numbers per_slope = hn::Div(one, slope);
  const Numbers newton = hn::Neg(hn::Mul(value, per_slope));
  const Numbers bend = hn::Mul(hn::Mul(curvature, per_slope), number(0.5));
  const Numbers step = hn::Div(newton, hn::MulAdd(newton, bend, one)), length = hn::Abs(step);
  const Numbers next = hn::Max(hn::Add(s, step), number(0.0));  // not before the flight
  const Chosen moves = hn::And(hn::Lt(hn::Mul(two, length), hn::Abs(before)), hn::Ne(next, s));
  const Numbers bends =
      hn::MulAdd(third, hn::Mul(hn::Abs(per_slope), number(1.0 / 6.0)), hn::Mul(bend, bend));
  const Numbers left = hn::Mul(hn::Mul(two, bends), hn::Mul(length, hn::Mul(length, length)));
  const Chosen exact = hn::Le(left, hn::Mul(number(kEps / 64.0), next));
  const Chosen goes = hn::And(chosen, moves), there = hn::AndNot(moves, chosen);
  lanes.keep(c.row(LaneRow::kThird), chosen, third);
  lanes.keep(c.row(LaneRow::kCorrection), chosen, step);
  go(lanes, goes, LaneStage::kFinish, next);
  const Numbers contact = hn::IfThenElse(there, s, next);
  const Chosen located = hn::Or(there, hn::And(goes, exact));
  go(lanes, located, LaneStage::kContact, contact);
  go(lanes, hn::And(located, hn::Gt(contact, window)), LaneStage::kEnd, window);
}

// One evaluation of the gaps of a vector and the step that follows, or a step of Halley's method.
HWY_INLINE void search_lanes(const LaneVector& lanes, Chosen search, Chosen finish,
                             LaneArrivals& arrivals) {
  const Numbers s = lanes.get(LaneRow::kAt), window = lanes.get(LaneRow::kWindow);
  const Numbers looks = hn::Add(lanes.get(LaneRow::kLooks), number(1.0));
  lanes.keep(lanes.columns->row(LaneRow::kLooks), looks);
  const Look look = look_at_all(lanes, search);
  lanes.keep(lanes.columns->row(LaneRow::kHit), look.crosses, look.hit);
  const Chosen goes = hn::AndNot(look.crosses, search);
  const Chosen ends = hn::And(goes, hn::Gt(look.until, window));
  go(lanes, goes, LaneStage::kSearch, look.until);
  go(lanes, ends, LaneStage::kEnd, window);
  const Chosen stands = hn::AndNot(hn::Gt(look.until, s), goes);
  const Chosen tires = hn::And(hn::Or(search, finish), hn::Gt(looks, number(kMostLooks)));
  const Chosen leaves = hn::Or(hn::Or(look.doubtful, stands), tires);
  const Chosen halley = hn::AndNot(leaves, hn::Or(finish, look.crosses));
  if (!hn::AllFalse(Lanes(), halley)) finish_step(lanes, halley, look.crosses);
  leave(lanes, leaves, arrivals);
}

// Impacts and ends of periods of a vector, and the flights that follow.
HWY_INLINE void arrive(const LaneVector& lanes, Chosen contact, Chosen end, Chosen fresh,
                       LaneArrivals& arrivals) {
  const Chosen arrived = hn::Or(contact, end), finite = end_flight(lanes, arrived);
  Numbers local = number(0.0);
  Chosen hits = hn::And(contact, finite);
  if (!hn::AllFalse(Lanes(), hits)) {
    hits = hit_stops(lanes, hits);
    const Numbers time = hn::Add(lanes.get(LaneRow::kLocal), lanes.get(LaneRow::kAt));
    local = hn::IfThenElse(hits, time, local);
  }
  const Chosen ends = hn::And(end, finite), begins = hn::Or(hits, ends);
  begin_flight(lanes, hn::Or(begins, fresh), hits, local);
  arrivals.contacts |= lane_set(hits, lanes.first);
  arrivals.ends |= lane_set(ends, lanes.first);
  leave(lanes, hn::AndNot(begins, arrived), arrivals);
}

// Arrivals are collected up to a quarter of a vector, since several cost as much time as one.
HWY_INLINE void advance(const LaneVector& lanes, LaneArrivals& arrivals) {
  const Chosen contact = lanes.is_at(LaneStage::kContact), end = lanes.is_at(LaneStage::kEnd);
  const Chosen fresh = lanes.is_at(LaneStage::kBegin);
  const Chosen search = lanes.is_at(LaneStage::kSearch), finish = lanes.is_at(LaneStage::kFinish);
  const bool searches = !hn::AllFalse(Lanes(), hn::Or(search, finish));
  if (searches) search_lanes(lanes, search, finish, arrivals);
  const Chosen waiting = hn::Or(hn::Or(contact, end), fresh);
  const std::size_t wait = hn::CountTrue(Lanes(), waiting);
  if (4 * wait > hn::Lanes(Lanes()) || (wait > 0 && !searches))
    arrive(lanes, contact, end, fresh, arrivals);
}

// Advances all vectors in turn, step by step, so that one works while another waits for a root or
// quotient.
void fly_lanes(const LaneColumns& columns, LaneArrivals& arrivals) {
  const std::size_t width = hn::Lanes(Lanes());
  std::array<LaneVector, kLanes> vectors;
  std::size_t count = 0;
  for (std::size_t first = 0; first < kLanes; first += width) {
    vectors[count] = {&columns, first};
    if (!hn::AllTrue(Lanes(), vectors[count].is_at(LaneStage::kIdle))) ++count;
  }
  while ((arrivals.contacts | arrivals.ends | arrivals.left) == 0) {
    for (std::size_t v = 0; v < count; ++v) turn_lanes(vectors[v]);
    for (std::size_t i = 0; i < columns.stops(); ++i)
      for (std::size_t v = 0; v < count; ++v) find_point(vectors[v], i);
    for (std::size_t i = 0; i < columns.stops(); ++i)
      for (std::size_t v = 0; v < count; ++v) look_at_stop(vectors[v], i);
    for (std::size_t v = 0; v < count; ++v) advance(vectors[v], arrivals);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace graze
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze {
namespace {

HWY_EXPORT(fly_lanes);

}  // namespace

LaneArrivals fly_lanes(LaneColumns& columns) {
  LaneArrivals arrivals;
  HWY_DYNAMIC_DISPATCH(fly_lanes)(columns, arrivals);
  return arrivals;
}

}  // namespace graze
#endif
