// Definitions of motion.hpp; included by one translation unit per scalar.
#pragma once

#include "graze/hybrid/first_zero.hpp"
#include "graze/hybrid/motion.hpp"
#include "graze/system/gap_value.hpp"

namespace graze {

template <class Real>
Motion<Real>::Motion(const System& system, const Instant<Real>& instant, const RealVector<Real>& q,
                     const RealVector<Real>& qdot)
    : flow_(system), arc_(flow_), instant_(instant), q_(q), qdot_(qdot) {
  for (const RigidStop& stop : system.stops) {
    stops_.push_back({stop.row.template cast<Real>(), stop.direction.template cast<Real>(),
                      Real(stop.gap), Real(stop.restitution), Contact::kClear});
    if (touches(stops_.back())) stops_.back().contact = Contact::kTouching;
  }
}

template <class Real>
bool Motion<Real>::touches(const Stop& stop) const {
  const GapValue<Real> gap = gap_value(stop.row, q_, stop.gap);
  return gap.value <= gap.rounding;
}

template <class Real>
Real Motion<Real>::gap(int stop) const {
  const Stop& s = stops_[static_cast<std::size_t>(stop)];
  return s.gap - s.row.dot(q_);
}

template <class Real>
Real Motion<Real>::approach_speed(int stop) const {
  return stops_[static_cast<std::size_t>(stop)].row.dot(qdot_);
}

template <class Real>
GapCurve<Real> Motion<Real>::gap_ahead(int stop, const Real& window) {
  arc_.start(flow_.phase(instant_), q_, qdot_);
  const Stop& s = stops_[static_cast<std::size_t>(stop)];
  return GapCurve<Real>(arc_, s.row, s.gap, window, s.contact != Contact::kClear);
}

template <class Real>
Arrival<Real> Motion<Real>::fly(const Real& until) {
  Arrival<Real> arrival;
  arc_.start(flow_.phase(instant_), q_, qdot_);
  arrival.flight = until - instant_.local;
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    const Stop& stop = stops_[i];
    const int index = static_cast<int>(i);
    const GapCurve<Real> curve(arc_, stop.row, stop.gap, arrival.flight,
                               stop.contact != Contact::kClear);
    int multiplicity = 0;
    if (stop.contact != Contact::kClear) {
      const CurvePoint<Real> rate = curve.at(Real(0), 1);
      if (stop.contact == Contact::kTouching && rate.value < -rate.noise)
        return {ArrivalKind::kContact, index, Real(0), approach_speed(index)};
      multiplicity = rate.value > rate.noise ? 1 : 2;
    }
    const FirstZero<Real> zero = first_contact(curve, multiplicity);
    if (zero.kind == ZeroKind::kNone) continue;
    arrival.stop = index;
    arrival.flight = zero.s;
    arrival.kind = zero.kind == ZeroKind::kBlocked     ? ArrivalKind::kRest
                   : zero.kind == ZeroKind::kBudget    ? ArrivalKind::kUndecided
                   : zero.kind == ZeroKind::kNotFinite ? ArrivalKind::kNotFinite
                                                       : ArrivalKind::kContact;
    if (arrival.kind == ArrivalKind::kNotFinite) return arrival;
  }
  move(arrival.flight, until);
  if (arrival.kind == ArrivalKind::kContact) {
    // The state decides: within rounding its speed can differ in sign from the curve's slope.
    arrival.speed = approach_speed(arrival.stop);
    if (!(arrival.speed > 0)) arrival.kind = ArrivalKind::kTouch;
  }
  if (arrival.kind == ArrivalKind::kContact)
    settle_on(stops_[static_cast<std::size_t>(arrival.stop)]);
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    const bool here = static_cast<int>(i) == arrival.stop;
    const bool stays = arrival.flight == 0 && !here;
    if (here)
      stops_[i].contact =
          arrival.kind == ArrivalKind::kTouch ? Contact::kDeparting : Contact::kTouching;
    else if (!stays)
      stops_[i].contact = Contact::kClear;
  }
  using std::isfinite;
  for (Eigen::Index j = 0; j < q_.size(); ++j)
    if (!isfinite(q_[j]) || !isfinite(qdot_[j])) arrival.kind = ArrivalKind::kNotFinite;
  return arrival;
}

template <class Real>
void Motion<Real>::move(const Real& flight, const Real& until) {
  const bool whole = flight == until - instant_.local;
  if (flight > 0) arc_.state(flight, q_, qdot_);
  instant_.local = whole ? until : Real(instant_.local + flight);
  if (instant_.local >= flow_.period()) {
    ++instant_.period;
    instant_.local = 0;
  }
}

// The located instant is rounded, the contact is not: row.q = gap holds as an identity, and the
// next arc starts from it. The offset, small against the present motion, would outlive a decaying
// one.
template <class Real>
void Motion<Real>::settle_on(const Stop& stop) {
  const Real offset = (stop.gap - stop.row.dot(q_)) / stop.row.squaredNorm();
  for (Eigen::Index j = 0; j < q_.size(); ++j) q_[j] += offset * stop.row[j];
}

template <class Real>
void Motion<Real>::impact(int stop) {
  Stop& s = stops_[static_cast<std::size_t>(stop)];
  const Real target = -s.restitution * s.row.dot(qdot_);
  // Twice: row.direction = 1 holds to rounding only, and errs to the same side at every impact.
  for (int pass = 0; pass < 2; ++pass) {
    const Real jump = s.row.dot(qdot_) - target;
    for (Eigen::Index j = 0; j < qdot_.size(); ++j) qdot_[j] -= jump * s.direction[j];
  }
  s.contact = Contact::kDeparting;
}

}  // namespace graze
