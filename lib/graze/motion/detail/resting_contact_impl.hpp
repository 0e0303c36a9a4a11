// Definitions of motion.hpp: rigid stops on which the structure rests beside springs that are only
// just entered.
//
// Neither the push nor its rate decides whether such a stop holds the structure or is left: the
// springs act as higher powers of time, under Hertz's law with exponents that are not integers. The
// structure is held there, and the motion itself decides, as for springs: the first instant at
// which a contact force exceeds its error (WalkingFlow::tells) shows the lowest power that does not
// vanish. The pushes at that instant, which have that power, are shared by complementarity; the
// motion then begins again at the same instant.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/contact/detail/complementarity.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

// For held stops in not_told_, unless nothing moves the structure there. That they hold is reported
// only once it is known.
template <class Real>
void Motion<Real>::ask_the_motion() {
  if (not_told_.empty() || turning_ || !frictions_.empty()) return;
  const std::vector<bool> moves = moving_modes();
  for (const int i : not_told_) {
    if (contact(i) != Contact::kClosed) continue;
    if (!is_sprung() || !is_moved(i, moves)) {
      set(i, Contact::kClosed, kHeldIdle);
      continue;
    }
    const bool is_new = std::erase_if(changes_, [&](const Change& change) {
                          return change.stop == i && change.kind == ArrivalKind::kStick;
                        }) > 0;
    set(i, Contact::kClosed, is_new ? kHeldUntold : kHeldBeforeUntold);
    phase_ = nullptr;
  }
}

// Where rounding let it leave: it is held by no force so far, and the motion tells beside springs.
template <class Real>
void Motion<Real>::rest_untold(int i) {
  if (is_independent(i, held()))
    set(i, Contact::kClosed, is_sprung() && frictions_.empty() ? kHeldUntold : kHeldIdle);
  else
    set(i, Contact::kLocked);
  phase_ = nullptr;
}

template <class Real>
std::vector<int> Motion<Real>::untold() const {
  std::vector<int> list;
  if (compliant_.empty()) return list;
  for (const int i : order_)
    if (contact(i) == Contact::kClosed
            ? multiplicity(i) == kHeldUntold || multiplicity(i) == kHeldBeforeUntold
            : contact(i) == Contact::kDeparting && multiplicity(i) == kLeftUntold)
      list.push_back(i);
  return list;
}

// Closed stops without a decided contact force are decided again after every change.
template <class Real>
void Motion<Real>::ask_again() {
  if (compliant_.empty()) return;
  for (const int i : order_)
    if (contact(i) == Contact::kClosed && multiplicity(i) > 0) undecided_ = recheck_ = true;
}

// Decides by the contact forces `arrival.sure` seconds after the start of the flight.
template <class Real>
void Motion<Real>::tell_forces(Arrival<Real>& arrival) {
  const std::vector<int> held = closed();
  const auto k = static_cast<Eigen::Index>(held.size());
  RealVector<Real> q, qdot, forces(k), rounding(k);
  phase_->state(arrival.sure, q, qdot);
  for (Eigen::Index a = 0; a < k; ++a) {
    const int i = held[static_cast<std::size_t>(a)];
    const Real norm2 = stop(i).row.squaredNorm();
    forces[a] = norm2 * phase_->force_at(i, arrival.sure, q, qdot);
    rounding[a] = norm2 * phase_->force_error(i);
  }
  const Matrix_ shares = pressing(held);
  const RealVector<Real> push = shares * forces;
  const RealVector<Real> summed = rounding_of_action(shares, forces);
  const std::optional<RealVector<Real>> shared = solve_contacts(shares, push, summed);
  if (!shared) {
    arrival.kind = ArrivalKind::kUndecided;
    return;
  }
  const RealVector<Real> into = push - shares * *shared;
  arrival.kind = ArrivalKind::kTouch;
  for (Eigen::Index a = 0; a < k; ++a) {
    const int i = held[static_cast<std::size_t>(a)];
    if (multiplicity(i) == 0) continue;
    // The stop of the arrival is decided for certain.
    const bool is_asked = i == arrival.stop;
    if ((*shared)[a] > (is_asked ? summed[a] : rounding[a])) {
      hold(i);
      be_sure_of(i, arrival.sure);
    } else if (is_asked || into[a] < -rounding[a] || forces[a] < -rounding[a]) {
      if (multiplicity(i) != kHeldUntold) changes_.push_back({ArrivalKind::kRelease, i});
      let_loose(i, kLeftUntold);
    }
  }
  phase_ = nullptr;
}

// When a contact force has reached zero and located the instant, the forces of other closed stops
// that are zero within rounding have vanished with it: bodies in a row, or beside a spring that is
// left.
template <class Real>
void Motion<Real>::vanish_together(const Real& flight) {
  using std::abs;
  if (!(flight > 0) || turning_) return;
  const std::vector<int> held = closed();
  if (held.empty()) return;
  vanished_ = flight;
  RealVector<Real> size;
  free_acceleration(&size);
  size += located_size();
  RealVector<Real> rounding(static_cast<Eigen::Index>(held.size()));
  for (std::size_t a = 0; a < held.size(); ++a)
    rounding[static_cast<Eigen::Index>(a)] = push_rounding(held[a], size);
  const RealVector<Real> errors = PivotedLu<Real>(pressing(held)).inverse().cwiseAbs() * rounding;
  for (std::size_t a = 0; a < held.size(); ++a)
    if (multiplicity(held[a]) == 0 && abs(force(held[a])) * stop(held[a]).row.squaredNorm() <=
                                          errors[static_cast<Eigen::Index>(a)])
      undecided_ = recheck_ = true;
  if (!recheck_) vanished_ = 0;
}

// The size, m/s^2, whose rounding is the error of the acceleration by the rounding of place and
// time at the end of the last flight.
template <class Real>
RealVector<Real> Motion<Real>::located_size() const {
  using std::abs;
  const Real eps = std::numeric_limits<Real>::epsilon();
  const Real speed = now_.qdot.norm() + departure_.qdot.norm();
  const Real place = now_.q.norm() + departure_.q.norm() + (now_.instant.local + vanished_) * speed;
  RealVector<Real> size(now_.q.size());
  for (Eigen::Index j = 0; j < size.size(); ++j) {
    size[j] = linear_.omega[j] * linear_.omega[j] * place + 2 * linear_.delta[j] * speed;
    if (linear_.coupling.size() > 0) size[j] += linear_.coupling.row(j).norm() * speed;
    if (linear_.forced)
      size[j] += linear_.highest_frequency() * (now_.instant.local + vanished_) *
                 linear_.force_size(j);
  }
  for (const int i : compliant_) {
    if (contact(i) != Contact::kCompressed) continue;
    const ContactForce& law = stop(i).force();
    const auto x = static_cast<double>(abs(depth(i))),
               v = static_cast<double>(abs(approach_speed(i)));
    const auto off = static_cast<double>(eps * stop(i).norm * place),
               faster = static_cast<double>(eps * stop(i).norm * speed);
    size += (law.at(x + off, v + faster) - law.at(x, v)) / eps * stop(i).row.cwiseAbs();
  }
  return size;
}

// Stops that it kept at rest elsewhere are to be decided again.
template <class Real>
void Motion<Real>::let_loose(int i, int multiplicity) {
  set(i, Contact::kDeparting, multiplicity);
  phase_ = nullptr;
  for (const int k : order_)
    if (contact(k) == Contact::kLocked) set(k, Contact::kTouching, 2);  // at rest there
  unlock_frictions();
}

}  // namespace graze
