// Definitions of motion.hpp: setting up and flying; included by one translation unit per
// scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "graze/contact/detail/impulse.hpp"
#include "graze/flow/detail/phase_choice.hpp"
#include "graze/motion/detail/arrival_impl.hpp"
#include "graze/motion/detail/chatter_impl.hpp"
#include "graze/motion/detail/contact_audit_impl.hpp"
#include "graze/motion/detail/contact_decision_impl.hpp"
#include "graze/motion/detail/friction_impl.hpp"
#include "graze/motion/detail/friction_series_impl.hpp"
#include "graze/motion/detail/impact_impl.hpp"
#include "graze/motion/detail/joint_impl.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/motion/detail/resting_contact_impl.hpp"
#include "graze/motion/detail/spring_contact_impl.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace motion_detail {

// Arrivals in a row without any flight: each stop may be hit, closed and opened a few times at one
// instant; after this many the motion counts as undecided.
inline constexpr int kMostArrivalsAtOnce = 1000;

// Number of phases that are cached, one for each set of closed stops and compressed springs; with
// many stops there are more than memory holds.
inline constexpr std::size_t kMostPhases = 64;

// Whether stop a comes before stop b in an order that does not depend on how they are listed.
inline bool precedes(const Stop& a, const Stop& b) {
  for (Eigen::Index j = 0; j < a.row.size(); ++j)
    if (a.row[j] != b.row[j]) return a.row[j] < b.row[j];
  if (a.gap != b.gap) return a.gap < b.gap;
  return a.restitution().coefficients() < b.restitution().coefficients();
}

}  // namespace motion_detail

template <class Real>
Motion<Real>::Motion(const System& system, const Instant<Real>& instant, const RealVector<Real>& q,
                     const RealVector<Real>& qdot, const std::optional<StepSetting>& steps)
    : system_(system), steps_(steps), clock_(system), linear_(linear_system<Real>(system)) {
  adopt_system();
  const std::size_t contacts = system_.stops.size() + frictions_.size();
  now_ = {instant, q, qdot, std::vector<Contact>(contacts, Contact::kClear),
          std::vector<int>(contacts, 0)};
  if (!frictions_.empty()) now_.places.emplace(frictions_.size(), 0.0);
  turn_directions();
  for (const int i : order_)
    if (touches(i)) set(i, Contact::kTouching);
  begin_springs();
  judge_frictions(Jumped::kVelocities);
  changes_.clear();
  look_at_joint();
}

template <class Real>
Motion<Real>::Motion(const System& system, const MotionState<Real>& state,
                     const std::optional<StepSetting>& steps)
    : system_(system), steps_(steps), clock_(system), linear_(linear_system<Real>(system)) {
  adopt_system();
  go_on_from(state);
}

template <class Real>
void Motion<Real>::go_on_from(const MotionState<Real>& state) {
  now_ = state;
  turn_directions();
  if (turning_) turning_->set_joint(now_.joint);
  undecided_ = std::any_of(now_.contacts.begin(), now_.contacts.end(),
                           [](Contact c) { return c == Contact::kTouching; });
  recheck_ = undecided_;
  ask_again();
  changes_.clear();
  phase_ = nullptr;
  if (!frictions_.empty()) note_rubbing();
  arrivals_at_once_ = 0;
  sure_.clear();
  entered_.clear();
  vanished_ = 0;
  eventful_ = false;
  broken_.reset();
  refusal_.clear();
}

template <class Real>
void Motion<Real>::adopt_system() {
  for (const Stop& stop : system_.stops) {
    (stop.is_compliant() ? compliant_ : order_).push_back(static_cast<int>(stops_.size()));
    const bool is_normal = !stop.is_compliant() && stop.direction() == momentum_direction(stop.row);
    const RealVector<Real> row = stop.row.template cast<Real>();
    stops_.push_back({row, stop.direction().template cast<Real>(), Real(stop.gap), row.norm(),
                      is_normal ? row.squaredNorm() : Real(0), &stop});
  }
  std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) {
    return motion_detail::precedes(system_.stops[static_cast<std::size_t>(a)],
                                   system_.stops[static_cast<std::size_t>(b)]);
  });
  all_ = order_;
  all_.insert(all_.end(), compliant_.begin(), compliant_.end());
  looked_at_ = all_;
  adopt_frictions();
  if (system_.turns()) turning_.emplace(system_);
}

template <class Real>
void Motion<Real>::leave_out(std::optional<int> stop) {
  left_out_ = stop;
  looked_at_ = all_;
  if (stop) std::erase(looked_at_, *stop);
  watched_ = looked_at_;
  watched_.insert(watched_.end(), frictions_.begin(), frictions_.end());
}

template <class Real>
inline void Motion<Real>::set(int i, Contact contact, int multiplicity) {
  const Contact before = this->contact(i);
  if (on_belts_ && before != contact) [[unlikely]]
    renew_places();
  now_.contacts[static_cast<std::size_t>(i)] = contact;
  now_.multiplicities[static_cast<std::size_t>(i)] = multiplicity;
  if (contact == Contact::kTouching) undecided_ = true;
  if (!frictions_.empty()) [[unlikely]]
    press_frictions(i, before);
}

template <class Real>
bool Motion<Real>::touches(int i) const {
  const GapValue<Real> gap = gap_value(stop(i).row, now_.q, stop(i).gap);
  return gap.value <= gap.rounding;
}

template <class Real>
std::vector<int> Motion<Real>::closed() const {
  std::vector<int> list;
  for (const int i : order_)
    if (contact(i) == Contact::kClosed) list.push_back(i);
  return list;
}

template <class Real>
std::vector<int> Motion<Real>::held() const {
  std::vector<int> list = closed();
  for (const int i : frictions_) {
    if (contact(i) == Contact::kClosed)
      list.push_back(i);
    else if (follows(i))
      list.push_back(system_.index_of_following(i));
  }
  return list;
}

template <class Real>
bool Motion<Real>::holds_anywhere() const {
  return std::any_of(now_.contacts.begin(), now_.contacts.end(),
                     [](Contact c) { return c == Contact::kClosed; });
}

template <class Real>
ContactPhase<Real>& Motion<Real>::phase_of(std::vector<int> closed) {
  PhaseKey key{std::move(closed), springs(), now_.joint, untold()};
  for (const int i : frictions_) {
    key.frictions.push_back(pushes(i, true)                 ? Contact::kForward
                            : pushes(i, false)              ? Contact::kBackward
                            : contact(i) == Contact::kClear ? Contact::kClear
                                                            : Contact::kClosed);
  }
  for (const int i : key.closed)
    if (system_.is_friction(i))
      key.places.push_back(system_.follows(i)
                               ? spring_length(i - static_cast<int>(frictions_.size()))
                               : (*now_.places)[place(i)]);
  KeptPhase& kept = phases_[key];
  kept.asked = ++asked_;
  if (kept.phase) return *kept.phase;
  const double angle = now_.joint == Joint::kHeld
                           ? system_.rotation()->angle.dot(now_.q.template cast<double>())
                           : 0.0;
  kept.phase = make_contact_phase<Real>(system_, key, steps_, angle);
  ContactPhase<Real>& phase = *kept.phase;
  if (phases_.size() > motion_detail::kMostPhases) forget_phase();
  return phase;
}

// Drops the phase that was used longest ago; the present and the last one are kept.
template <class Real>
void Motion<Real>::forget_phase() {
  auto oldest = phases_.end();
  for (auto kept = phases_.begin(); kept != phases_.end(); ++kept)
    if (kept->second.phase.get() != phase_ && kept->second.phase.get() != flown_ &&
        (oldest == phases_.end() || kept->second.asked < oldest->second.asked))
      oldest = kept;
  forgotten_evaluations_ += oldest->second.phase->evaluations();
  phases_.erase(oldest);
}

template <class Real>
ContactPhase<Real>& Motion<Real>::start_phase() {
  if (!phase_) phase_ = &phase_of(held());
  start_at_now(*phase_);
  return *phase_;
}

template <class Real>
void Motion<Real>::start_at_now(ContactPhase<Real>& phase) const {
  phase.start(clock_.phase(now_.instant), now_.q, now_.qdot, now_.instant.local);
}

template <class Real>
Real Motion<Real>::gap(int i) const {
  return stop(i).gap - stop(i).row.dot(now_.q);
}

template <class Real>
Real Motion<Real>::approach_speed(int i) const {
  return stop(i).row.dot(now_.qdot) - stop(i).belt;
}

template <class Real>
const ArcCurve<Real>& Motion<Real>::gap_ahead(int i, const Real& window) {
  const ContactPhase<Real>& phase = start_phase();
  // No flight goes beyond, wherever a run is cut.
  const Real ahead = std::min(window, Real(phase.longest_flight()));
  return phase.exact()->gap(i, ahead, contact(i) != Contact::kClear);
}

template <class Real>
Arrival<Real> Motion<Real>::fly(const Real& until, const Real& horizon) {
  const Instant<Real> start = now_.instant;
  std::optional<Arrival<Real>> arrival = broken_;
  if (!arrival && changes_.empty() && undecided_) arrival = decide();
  if (!arrival && !changes_.empty()) {
    arrival = Arrival<Real>{changes_.front().kind, changes_.front().stop};
    arrival->below = contact(arrival->stop) == Contact::kParted;
    changes_.erase(changes_.begin());
  }
  if (!arrival && !(until > now_.instant.local)) arrival = stay();
  if (!arrival) arrival = arrive(search(until, horizon), until);
  // A call for pending events alone is no progress, but is not counted; a flight too short to
  // advance the clock is no progress either.
  if (now_.instant.period != start.period || now_.instant.local != start.local)
    arrivals_at_once_ = 0;
  else if (arrival->kind != ArrivalKind::kTime)
    ++arrivals_at_once_;
  if (arrivals_at_once_ > motion_detail::kMostArrivalsAtOnce) {
    const auto touched = std::count_if(order_.begin(), order_.end(),
                                       [&](int i) { return contact(i) != Contact::kClear; });
    arrival->kind = touched > kFewContacts ? ArrivalKind::kRefused : ArrivalKind::kUndecided;
    if (touched > kFewContacts)
      refusal_ = std::to_string(touched) +
                 " stops are touched at this instant, and what they do to each other has no "
                 "solution that holds within rounding";
  }
  return *arrival;
}

// A stop that belongs to the key of the phase; -1: there is none, as on a rotating hub alone.
template <class Real>
int Motion<Real>::first_of(const ContactPhase<Real>& phase) {
  if (!phase.closed().empty()) return phase.closed().front();
  if (phase.springs().empty()) return -1;
  return phase.springs().all().front();
}

// A flight of no length, for pending events alone.
template <class Real>
Arrival<Real> Motion<Real>::stay() {
  departure_ = now_;
  const ContactPhase<Real>& phase = start_phase();
  flown_ = phase_;
  if (phase.refusal().empty()) return {};
  refusal_ = phase.refusal();
  return {ArrivalKind::kRefused, first_of(phase)};
}

// The first event along the arc that starts now.
template <class Real>
Arrival<Real> Motion<Real>::search(const Real& until, const Real& horizon) {
  if (!frictions_.empty()) note_series();
  departure_ = now_;
  ContactPhase<Real>& phase = start_phase();
  if (!phase.refusal().empty()) {
    refusal_ = phase.refusal();
    return {ArrivalKind::kRefused, first_of(phase)};
  }
  if (std::exchange(eventful_, false)) audit_forces();
  if (broken_) return *broken_;
  const Real left = until - now_.instant.local;
  // Certainty about a flight with other velocities does not apply to this one.
  if (!sure_.empty() && sure_speeds_ != now_.qdot) sure_.clear();
  const Arrival<Real> arrival = phase.first_event(
      now_, {left, horizon - now_.instant.local, watched_, stop_, told_depth_, sure_});
  if (arrival.kind != ArrivalKind::kNotFinite && arrival.flight > left)
    return {ArrivalKind::kTime, -1, left, Real(0), arrival.evaluations, arrival.lowest};
  return arrival;
}

template <class Real>
long long Motion<Real>::step_evaluations() const {
  long long sum = forgotten_evaluations_;
  for (const auto& [key, kept] : phases_) sum += kept.phase->evaluations();
  return sum;
}

}  // namespace graze
