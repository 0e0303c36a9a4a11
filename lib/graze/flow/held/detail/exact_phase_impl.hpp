// Definitions of exact_phase.hpp; included by one translation unit per scalar.
#pragma once

#include <algorithm>
#include <type_traits>

#include "graze/flow/exact/detail/arc_curve_impl.hpp"
#include "graze/flow/exact/detail/first_zero.hpp"
#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

template <class Real>
ExactPhase<Real>::ExactPhase(const System& system, PhaseKey key,
                             ConstrainedStructure<Real> structure)
    : ExactPhase(system, std::move(key), structure, structure.observables(system)) {}

template <class Real>
ExactPhase<Real>::ExactPhase(const System& system, PhaseKey key,
                             ConstrainedStructure<Real> structure,
                             std::vector<Observable<Real>> observables)
    : ContactPhase<Real>(std::move(key)),
      structure_(std::move(structure)),
      observables_(std::move(observables)),
      limits_(system.frictions.size()),
      kept_(observables_.size()) {
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    const RealVector<Real> none = RealVector<Real>::Zero(structure_.size());
    limits_[k] = {Real(system.frictions[k].sticking), none, {}, {}};
    if (this->key().frictions.empty() || this->key().frictions[k] != Contact::kBackward) continue;
    Observable<Real>& speed = observables_[system.stops.size() + k];
    speed = times(Real(-1), std::move(speed));
  }
}

template <class Real>
void ExactPhase<Real>::forget_curves() {
  for (KeptCurve& kept : kept_) kept.known = false;
}

template <class Real>
const ArcCurve<Real>& ExactPhase<Real>::gap(int stop, const Real& window, bool from_zero) const {
  KeptCurve& kept = kept_[static_cast<std::size_t>(stop)];
  if (kept.known && kept.from_zero == from_zero) {
    kept.curve.set_window(window);
    return kept.curve;
  }
  kept.known =
      set_curve(kept.curve, observables_[static_cast<std::size_t>(stop)], window, from_zero);
  kept.from_zero = from_zero;
  return kept.curve;
}

template <class Real>
ArcCurve<Real> ExactPhase<Real>::curve(const Observable<Real>& observable,
                                       const Real& window) const {
  ArcCurve<Real> curve;
  set_curve(curve, observable, window, false);
  return curve;
}

template <class Real>
Arrival<Real> ExactPhase<Real>::first_event(const MotionState<Real>& now,
                                            const Flight<Real>& flight) {
  Arrival<Real> arrival;
  arrival.flight = std::min<Real>(flight.horizon, this->longest_flight());
  for (const int i : flight.order) {
    const Contact at = now.contacts[static_cast<std::size_t>(i)];
    if (at == Contact::kLocked || at == Contact::kCompressed || at == Contact::kParted) continue;
    const bool is_closed = at == Contact::kClosed;
    const bool rubs = static_cast<std::size_t>(i) >= observables_.size() - limits_.size();
    if (rubs && at == Contact::kClear) continue;  // nothing presses there
    const int multiplicity = now.multiplicities[static_cast<std::size_t>(i)];
    if (rubs && is_closed && multiplicity == kHeldIdle) continue;
    const Slip slip =
        is_closed && rubs ? first_slip(i, arrival.flight, multiplicity, &flight) : Slip{};
    const FirstZero<Real> zero =
        is_closed ? (rubs ? slip.zero
                          : first_release(force(i, arrival.flight), flight.stop, flight.sure_of(i)))
                  : first_contact(gap(i, arrival.flight, multiplicity > 0), multiplicity,
                                  flight.sure_of(i), flight.stop);
    arrival.evaluations += zero.evaluations;
    if (zero.kind == ZeroKind::kNone) continue;
    arrival.stop = i;
    arrival.flight = zero.s;
    arrival.kind = zero.kind == ZeroKind::kBudget      ? ArrivalKind::kUndecided
                   : zero.kind == ZeroKind::kNotFinite ? ArrivalKind::kNotFinite
                   : rubs && is_closed                 ? ArrivalKind::kSlip
                   : rubs                              ? ArrivalKind::kStandstill
                   : zero.kind == ZeroKind::kBlocked   ? ArrivalKind::kTouch
                   : is_closed                         ? ArrivalKind::kRelease
                                                       : ArrivalKind::kContact;
    arrival.forward = slip.forward;
    if (arrival.kind == ArrivalKind::kNotFinite) break;
  }
  return arrival;
}

// Friction lets go forwards where what the structure exerts on it exceeds the limit, and backwards.
template <class Real>
typename ExactPhase<Real>::Slip ExactPhase<Real>::first_slip(int friction, const Real& window,
                                                             int came,
                                                             const Flight<Real>* flight) const {
  using std::abs;
  const StopSignal never;
  const StopSignal& stop = flight ? flight->stop : never;
  const auto place = static_cast<std::size_t>(friction);
  const Observable<Real>& limit = limits_[place - (observables_.size() - limits_.size())];
  Slip first;
  Real until = window;
  long long evaluations = 0;
  for (const bool forward : {true, false}) {
    const Observable<Real> left = limit + times(Real(forward ? -1 : 1), observables_[place]);
    // Where it stuck at its limit just now, this is left as the square of time, or, after an
    // impact, with a speed.
    const bool from_zero = came == (forward ? kCameForward : kCameBackward);
    ArcCurve<Real> ahead;
    set_curve(ahead, left, until, from_zero);
    const auto leaves = [&] {
      for (int order = 1; order <= 3; ++order)
        if (const CurvePoint<Real> rate = ahead.at(Real(0), order); abs(rate.value) > rate.noise)
          return order;
      return 0;
    };
    const int order = from_zero ? leaves() : 0;
    if (from_zero && order == 0) continue;  // its place is held, too
    const FirstZero<Real> zero =
        from_zero ? first_contact(ahead, order, Real(0), stop) : first_release(ahead, stop);
    evaluations += zero.evaluations;
    if (zero.kind == ZeroKind::kNone) continue;
    first = {zero, forward};
    if (zero.kind != ZeroKind::kCrossing && zero.kind != ZeroKind::kTouch) break;
    until = zero.s;
  }
  first.zero.evaluations = static_cast<int>(evaluations);
  return first;
}

template <class Real>
CurvePoint<Real> ExactPhase<Real>::gap_rate(int stop, int order) const {
  return gap(stop, Real(0), true).at(Real(0), order);
}

template <class Real>
CurvePoint<Real> ExactPhase<Real>::outlook(int stop, int order, const Real& ahead) const {
  return structure_.holds(stop) ? force(stop, ahead).at(Real(0), order)
                                : gap(stop, ahead, true).at(Real(0), order);
}

template <class Real>
bool ExactPhase<Real>::stays_quiet(int stop, const Real& duration) const {
  const bool rubs = static_cast<std::size_t>(stop) >= observables_.size() - limits_.size();
  const FirstZero<Real> zero = !structure_.holds(stop)
                                   ? first_contact(gap(stop, duration, false), 0)
                               : rubs ? first_slip(stop, duration, 0, nullptr).zero
                                      : first_release(force(stop, duration));
  return zero.kind == ZeroKind::kNone;
}

template <class Real>
Real ExactPhase<Real>::force_at(int stop, const Real& s, const RealVector<Real>& q,
                                const RealVector<Real>& qdot) const {
  const Real theta = start_phase() + structure_.reduced.frequency * s;
  return observed<Real>(observables_[static_cast<std::size_t>(stop)], theta,
                        structure_.coordinates(q, theta), structure_.rates(qdot, theta))
      .value;
}

template <class Real>
Real ExactPhase<Real>::force_rate(int stop) const {
  return force(stop, Real(0)).at(Real(0), 0).slope;
}

template <class Real>
FreePhase<Real>::FreePhase(const System& system, PhaseKey key)
    : ExactPhase<Real>(system, std::move(key), ConstrainedStructure<Real>(system, {})),
      flow_(this->structure().reduced),
      arc_(flow_) {
  if constexpr (std::is_same_v<Real, double>)
    if (flow_.modes() > kFewModes && system.frictions.empty())
      search_ = std::make_unique<FlightSearch>(system, this->structure().reduced);
}

template <class Real>
Arrival<Real> FreePhase<Real>::first_event(const MotionState<Real>& now,
                                           const Flight<Real>& flight) {
  if constexpr (std::is_same_v<Real, double>)
    if (search_) {
      const auto curves = [this](int stop, double window,
                                 bool from_zero) -> const ArcCurve<double>& {
        return this->gap(stop, window, from_zero);
      };
      return search_->first_event(curves, arc_, now, flight);
    }
  return ExactPhase<Real>::first_event(now, flight);
}

// An arc at the same start serves both decisions at an instant and the flight from there.
template <class Real>
void FreePhase<Real>::start(const Real& theta, const RealVector<Real>& q,
                            const RealVector<Real>& qdot, const Real& /*time*/) {
  if (arc_.starts_at(theta, q, qdot)) return;
  this->forget_curves();
  arc_.start(theta, q, qdot);
}

template <class Real>
void FreePhase<Real>::state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const {
  arc_.state(s, q, qdot);
}

template <class Real>
bool FreePhase<Real>::set_curve(ArcCurve<Real>& curve, const Observable<Real>& observable,
                                const Real& window, bool from_zero) const {
  curve.restart(arc_, observable, window, from_zero);
  return true;
}

template <class Real>
ConstrainedPhase<Real>::ConstrainedPhase(const System& system, PhaseKey key,
                                         ConstrainedStructure<Real> structure)
    : ExactPhase<Real>(system, std::move(key), std::move(structure)),
      flow_(this->structure().reduced),
      arc_(flow_) {}

template <class Real>
std::string ConstrainedPhase<Real>::refusal() const {
  if (this->structure().has_real_modes) return {};
  return "the constrained motion has no real modes; it is followed in double precision only";
}

template <class Real>
void ConstrainedPhase<Real>::start(const Real& theta, const RealVector<Real>& q,
                                   const RealVector<Real>& qdot, const Real& /*time*/) {
  this->forget_curves();
  arc_.start(theta, this->structure().coordinates(q, theta), this->structure().rates(qdot, theta));
}

template <class Real>
void ConstrainedPhase<Real>::state(const Real& s, RealVector<Real>& q,
                                   RealVector<Real>& qdot) const {
  const Eigen::Index m = this->structure().size();
  RealVector<Real> y(m), ydot(m);
  arc_.state(s, y, ydot);
  q = this->structure().displacements(y);
  qdot = this->structure().velocities(ydot);
}

template <class Real>
bool ConstrainedPhase<Real>::set_curve(ArcCurve<Real>& curve, const Observable<Real>& observable,
                                       const Real& window, bool from_zero) const {
  curve.restart(arc_, observable, window, from_zero);
  return true;
}

}  // namespace graze
