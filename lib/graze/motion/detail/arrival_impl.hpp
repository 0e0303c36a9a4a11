// Definitions of motion.hpp: the end of a flight.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {

// Moves to the end of a flight, before the event there is decided.
template <class Real>
void Motion<Real>::land(const Real& flight) {
  sure_.clear();
  entered_.clear();
  vanished_ = 0;
  phase_->state(flight, now_.q, now_.qdot);
  audit_gaps(flight);
  // A stop that was left within rounding still counts as touched: the sign of its gap is rounding.
  for (const int i : all_)
    if (contact(i) == Contact::kDeparting)
      set(i, touches(i) ? Contact::kTouching : Contact::kClear);
  ask_again();
  if (recheck_) vanished_ = flight;
  turn_directions();
  for (const int i : compliant_) {
    if (contact(i) == Contact::kLocked && multiplicity(i) == 0)
      set(i, touches(i) ? Contact::kTouching : Contact::kClear);
    else if (contact(i) == Contact::kCompressed || contact(i) == Contact::kParted)
      set(i, contact(i));
  }
  for (const int i : frictions_)
    if (contact(i) != Contact::kTouching && contact(i) != Contact::kLocked) set(i, contact(i));
}

// On a rigid stop that it has left from rest, before the clock feels it: only rounding can do that.
template <class Real>
bool Motion<Real>::is_back_at_once(const Arrival<Real>& arrival) const {
  return (arrival.kind == ArrivalKind::kContact || arrival.kind == ArrivalKind::kTouch) &&
         arrival.stop >= 0 && !stop(arrival.stop).is_compliant() &&
         contact(arrival.stop) == Contact::kDeparting && multiplicity(arrival.stop) > 1 &&
         Real(now_.instant.local + arrival.flight) == now_.instant.local;
}

template <class Real>
Arrival<Real> Motion<Real>::arrive(Arrival<Real> arrival, const Real& until) {
  using std::isfinite;
  flown_ = phase_;
  const bool whole = arrival.flight == until - now_.instant.local;
  const bool returns = is_back_at_once(arrival);
  if (arrival.flight > 0) land(arrival.flight);
  now_.instant.local = whole ? until : Real(now_.instant.local + arrival.flight);
  if (now_.instant.local >= clock_.period()) {
    ++now_.instant.period;
    now_.instant.local = 0;
  }
  if (!isfinite(now_.instant.local)) {
    arrival.kind = ArrivalKind::kNotFinite;
    return arrival;
  }
  for (Eigen::Index j = 0; j < now_.q.size(); ++j)
    if (!isfinite(now_.q[j]) || !isfinite(now_.qdot[j])) {
      arrival.kind = ArrivalKind::kNotFinite;
      return arrival;
    }
  if (broken_) {
    arrival.kind = broken_->kind;
    arrival.stop = broken_->stop;
    return arrival;
  }
  eventful_ = arrival.kind != ArrivalKind::kTime;
  if (arrival.stop >= 0 && stop(arrival.stop).is_compliant() &&
      arrival.kind != ArrivalKind::kTime && arrival.kind != ArrivalKind::kUndecided) {
    arrive_at_spring(arrival);
    if (arrival.kind == ArrivalKind::kSeparation || arrival.kind == ArrivalKind::kLeft)
      vanish_together(arrival.flight);
    return arrival;
  }
  if (arrival.told) {
    tell_forces(arrival);
    return arrival;
  }
  if (returns && !(approach_speed(arrival.stop) > speed_rounding(arrival.stop))) {
    arrival.kind = ArrivalKind::kTouch;
    rest_untold(arrival.stop);
    return arrival;
  }
  switch (arrival.kind) {
    case ArrivalKind::kJoint: {
      // Friction jumps when a rotating joint stops; the torque on a held joint grows up to the
      // friction.
      const bool stops = now_.joint != Joint::kHeld;
      arrive_at_joint(arrival.forward);
      if (stops) judge_again(Jumped::kForces);
      break;
    }
    case ArrivalKind::kContact:
      // A gap that reaches zero without approach speed needs no impact: the motion grazes the stop,
      // or comes within rounding of that.
      arrival.speed = approach_speed(arrival.stop);
      if (!(arrival.speed > 0)) arrival.kind = ArrivalKind::kTouch;
      [[fallthrough]];
    case ArrivalKind::kTouch:
      set(arrival.stop, Contact::kTouching);
      if (arrival.kind == ArrivalKind::kContact) {
        settle_on(arrival.stop, arrival.flight);
        touch_simultaneous(arrival.flight);
      }
      break;
    case ArrivalKind::kStandstill:
      arrive_at_standstill(arrival.stop, arrival.flight == 0);
      break;
    case ArrivalKind::kSlip:
      if (!arrive_at_slip(arrival.stop, arrival.forward)) arrival.kind = ArrivalKind::kStandstill;
      break;
    case ArrivalKind::kRelease:
      let_loose(arrival.stop, 3);
      vanish_together(arrival.flight);
      break;
    default:
      break;
  }
  return arrival;
}

// Other stops whose gap vanishes at the located instant, within its rounding and that of time.
template <class Real>
void Motion<Real>::touch_simultaneous(const Real& flight) {
  using std::abs;
  const Real eps = std::numeric_limits<Real>::epsilon();
  const Real shape = now_.q.norm(), speed = now_.qdot.norm();
  for (const int i : order_) {
    if (contact(i) != Contact::kClear || i == left_out_) continue;
    // Compares sizes first: of many stops nearly all are far away.
    const MetStop& s = stop(i);
    const Real most =
        Real(static_cast<int>(now_.q.size()) + 2) * eps * (abs(s.gap) + s.norm * shape) +
        eps * (now_.instant.local + flight) * s.norm * speed;
    if (this->gap(i) > 2 * most) continue;
    const GapValue<Real> gap = gap_value(stop(i).row, now_.q, stop(i).gap);
    const Real moved = eps * (now_.instant.local + flight) * abs(approach_speed(i));
    if (!(gap.value <= gap.rounding + moved)) continue;
    set(i, Contact::kTouching);
    settle_on(i, flight);
  }
}

// The located instant is rounded, the contact is not: row.q = gap is made to hold exactly, and the
// next arc starts from it. The offset, small against the present motion, would outlive a decaying
// one. It is spread over the modes by the square of their displacements, as rounding has spread it:
// no mode changes beyond its last digits, and the energy, mostly of stiff modes, hardly at all.
// What closed stops hold stays where it is: moved off them it would be put back at the start of the
// next arc, and off this stop again, by more than the offset was.
template <class Real>
void Motion<Real>::settle_on(int i, const Real& flight) {
  using std::abs;
  const MetStop& s = stop(i);
  const auto moves = [&](Eigen::Index j) {
    const Real w = linear_.omega[j];
    return Real(abs(now_.q[j]) + abs(now_.qdot[j]) * (w * flight > 1 ? Real(1 / w) : flight));
  };
  // Relative to the largest, whose square might be out of range.
  Real largest = 0;
  for (Eigen::Index j = 0; j < now_.q.size(); ++j) largest = std::max(largest, moves(j));
  const auto part = [&](Eigen::Index j) {
    return largest > 0 ? Real(moves(j) / largest) : Real(0);
  };
  if (holds_anywhere()) {
    RealVector<Real> weights(now_.q.size());
    for (Eigen::Index j = 0; j < weights.size(); ++j) weights[j] = part(j);
    if (settle_among_closed(i, weights)) return;
  }
  const auto share = [&](Eigen::Index j) {
    const Real of = part(j);
    return Real(s.row[j] * of * of);
  };
  Real whole = 0;
  for (Eigen::Index j = 0; j < now_.q.size(); ++j) whole += s.row[j] * share(j);
  const Real offset = s.gap - s.row.dot(now_.q);
  if (whole > 0)
    for (Eigen::Index j = 0; j < now_.q.size(); ++j) now_.q[j] += offset * (share(j) / whole);
  else
    now_.q += (offset / s.row.squaredNorm()) * s.row;
  // The remaining offset has the rounding of the old gap, which exceeds that of a gap of zero.
  const GapValue<Real> left = gap_value(s.row, now_.q, s.gap);
  if (!(abs(left.value) > left.rounding)) return;
  Eigen::Index most = 0;
  s.row.cwiseAbs().maxCoeff(&most);
  now_.q[most] = 0;
  now_.q[most] = (s.gap - s.row.dot(now_.q)) / s.row[most];
}

// The same where other stops are closed, whose rows are settled with this one; false where the
// weights leave them no way.
template <class Real>
bool Motion<Real>::settle_among_closed(int i, const RealVector<Real>& weights) {
  std::vector<int> kept = held();
  kept.insert(kept.begin(), i);
  const auto count = static_cast<Eigen::Index>(kept.size());
  Matrix_ rows(now_.q.size(), count);
  RealVector<Real> offsets(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const MetStop& one = stop(kept[static_cast<std::size_t>(a)]);
    rows.col(a) = one.row;
    offsets[a] = one.given ? Real(one.gap - one.row.dot(now_.q)) : Real(0);
  }
  const Matrix_ shares = weights.cwiseAbs2().asDiagonal() * rows;
  const PivotedLu<Real> crossed(transposed_product<Real>(rows, shares));
  if (!crossed.is_invertible()) return false;
  now_.q += image<Real>(shares, crossed.solve(offsets));
  return true;
}

}  // namespace graze
