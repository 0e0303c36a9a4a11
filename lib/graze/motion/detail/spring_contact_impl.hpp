// Definitions of motion.hpp: compliant stops.
//
//   clear -> touching -> compressed -> departing -> clear
//               | ^          | ^
//               v |          v |   force gone beyond the surface, and back
//              locked       parted -> departing
//
// Nothing jumps: an entry or a separation changes which forces act, and begins a new phase.
//
// The first derivative of the gap that exceeds its rounding decides whether a touched surface is
// entered or left: the speed, the push, or its rate. The motion itself decides where none of them
// does although the structure is moved there: the force of another spring that has just been
// entered grows as a higher power of time, with an exponent that is no integer under Hertz's law.
// The spring is then "resting" in the phase, and acts beyond its surface, until its depth exceeds
// its error (WalkingFlow::tells). It counts as entered or left since the start of that flight.
#pragma once

#include <algorithm>
#include <cmath>

#include "graze/motion/detail/motion.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {

template <class Real>
PhaseSprings Motion<Real>::springs() const {
  PhaseSprings springs;
  for (const int i : compliant_) {
    if (contact(i) == Contact::kCompressed) springs.loaded.push_back(i);
    if (contact(i) == Contact::kParted) springs.parted.push_back(i);
    if (contact(i) == Contact::kLocked && multiplicity(i) > 0) springs.resting.push_back(i);
  }
  return springs;
}

// Depth beyond the surface, m; zero within the rounding of the gap, and when the surface has just
// been entered, whatever the rounding of bodies that have moved elsewhere.
template <class Real>
Real Motion<Real>::depth(int i) const {
  if (std::find(entered_.begin(), entered_.end(), i) != entered_.end()) return 0;
  return depth_value(stop(i).row, now_.q, stop(i).gap);
}

template <class Real>
Real Motion<Real>::spring_force(int i) const {
  if (contact(i) != Contact::kCompressed) return 0;
  return Real(
      stop(i).force().at(static_cast<double>(depth(i)), static_cast<double>(approach_speed(i))));
}

template <class Real>
double Motion<Real>::spring_energy(int i) const {
  return stop(i).force().stored(static_cast<double>(depth(i)));
}

template <class Real>
void Motion<Real>::add_spring_forces(RealVector<Real>& acceleration, RealVector<Real>* size) const {
  using std::abs;
  for (const int i : compliant_) {
    const Real force = spring_force(i);
    if (force == 0) continue;
    const RealVector<Real> row = pushing(i);
    acceleration -= force * row;
    if (size) *size += abs(force) * row.cwiseAbs();
  }
}

// A motion that starts beyond a surface is acted on by the spring from there.
template <class Real>
void Motion<Real>::begin_springs() {
  for (const int i : compliant_) {
    if (!touches(i)) continue;
    if (depth(i) > 0)
      compress(i);
    else
      set(i, Contact::kTouching);
  }
}

template <class Real>
void Motion<Real>::compress(int i) {
  const ContactForce& law = stop(i).force();
  const bool holds = !law.parts_early() || law.grip(static_cast<double>(depth(i)),
                                                    static_cast<double>(approach_speed(i))) >= 0.0;
  set(i, holds ? Contact::kCompressed : Contact::kParted);
  phase_ = nullptr;
}

// After a jump of the velocities, or of the force of a spring, at this instant every other contact
// is decided again: springs here, by their forces, which depend on velocities; touched surfaces and
// closed stops by decide().
template <class Real>
void Motion<Real>::judge_again(Jumped what) {
  for (const int i : compliant_) {
    const Contact before = contact(i);
    const bool rests =
        (before == Contact::kLocked && (multiplicity(i) == 0 || what == Jumped::kVelocities)) ||
        (before == Contact::kDeparting && now_.multiplicities[static_cast<std::size_t>(i)] > 1);
    if (rests || (before == Contact::kDeparting && what == Jumped::kVelocities))
      set(i, Contact::kTouching);
    // Entered from rest before: the velocity decides now.
    if (before == Contact::kCompressed && what == Jumped::kVelocities) set(i, before);
    if (what == Jumped::kForces || !stop(i).force().parts_early()) continue;
    // At its surface the next phase decides whether it is left.
    if ((before != Contact::kCompressed && before != Contact::kParted) || !(depth(i) > 0)) continue;
    compress(i);
    if (contact(i) != before)
      changes_.push_back(
          {before == Contact::kParted ? ArrivalKind::kEntry : ArrivalKind::kSeparation, i});
  }
  if (!frictions_.empty()) judge_frictions(what);
  if (holds_anywhere()) undecided_ = recheck_ = true;
}

// Of the touched springs, those that are approached are entered, those that recede are left.
template <class Real>
void Motion<Real>::decide_moving_springs() {
  for (const int i : compliant_) {
    if (contact(i) != Contact::kTouching) continue;
    const Real speed = approach_speed(i), rounding = speed_rounding(i);
    if (speed < -rounding) {
      set(i, Contact::kDeparting, 1);
    } else if (speed > rounding || depth(i) > 0) {
      if (speed > rounding) entered_.push_back(i);
      compress(i);
      changes_.push_back({ArrivalKind::kEntry, i});
      if (!stop(i).force().sets_in_smoothly()) judge_again(Jumped::kForces);
    }
  }
}

// Decides the springs touched at rest once the other forces are known: all of them by their pushes,
// then by the rates of these, which depend on the springs entered by then.
template <class Real>
void Motion<Real>::decide_resting_springs() {
  using std::abs;
  std::vector<int> resting;
  for (const int i : compliant_)
    if (contact(i) == Contact::kTouching) resting.push_back(i);
  for (int order = 2; order <= 3 && !resting.empty(); ++order) {
    const ContactPhase<Real>& phase = start_phase();
    if (!phase.refusal().empty()) break;
    std::vector<CurvePoint<Real>> rates;
    for (const int i : resting) rates.push_back(phase.gap_rate(i, order));
    std::vector<int> untold;
    for (std::size_t a = 0; a < resting.size(); ++a) {
      const int i = resting[a];
      if (!(abs(rates[a].value) > rates[a].noise)) {
        untold.push_back(i);
      } else if (rates[a].value > 0) {
        set(i, Contact::kDeparting, order);
      } else {
        set(i, Contact::kCompressed, order);
        entered_.push_back(i);
        changes_.push_back({ArrivalKind::kEntry, i});
        phase_ = nullptr;
      }
    }
    resting = std::move(untold);
  }
  if (resting.empty()) return;
  const std::vector<bool> moves = moving_modes();
  // Beside friction phases in closed form are needed, which cannot ask the motion.
  const bool may_ask = frictions_.empty();
  for (const int i : resting) set(i, Contact::kLocked, may_ask && is_moved(i, moves) ? 1 : 0);
  phase_ = nullptr;
}

// Modes at rest without any force stay at rest, unless a touched stop couples them to others.
template <class Real>
std::vector<bool> Motion<Real>::moving_modes() const {
  const Eigen::Index n = now_.q.size();
  std::vector<bool> moves(static_cast<std::size_t>(n), static_cast<bool>(turning_));
  if (turning_) return moves;
  const RealVector<Real> acceleration = free_acceleration();
  for (Eigen::Index j = 0; j < n; ++j)
    moves[static_cast<std::size_t>(j)] =
        now_.qdot[j] != 0 || acceleration[j] != 0 || linear_.force_size(j) != 0;
  // Each pass couples at least one stop.
  std::vector<int> apart;
  for (const int i : all_)
    if (contact(i) != Contact::kClear) apart.push_back(i);
  const auto connects = [&](int i) {
    if (!is_moved(i, moves)) return false;
    for (Eigen::Index j = 0; j < n; ++j)
      if (stop(i).row[j] != 0 || stop(i).direction[j] != 0)
        moves[static_cast<std::size_t>(j)] = true;
    return true;
  };
  while (std::erase_if(apart, connects) > 0) {
  }
  return moves;
}

template <class Real>
bool Motion<Real>::is_moved(int i, const std::vector<bool>& moves) const {
  for (Eigen::Index j = 0; j < now_.q.size(); ++j)
    if (stop(i).row[j] != 0 && moves[static_cast<std::size_t>(j)]) return true;
  return false;
}

// The located instant is rounded, but the surface was reached exactly.
template <class Real>
void Motion<Real>::arrive_at_spring(Arrival<Real>& arrival) {
  const int i = arrival.stop;
  arrival.speed = approach_speed(i);
  phase_ = nullptr;
  if (contact(i) == Contact::kLocked) {
    set(i, arrival.kind == ArrivalKind::kEntry ? Contact::kCompressed : Contact::kDeparting);
    if (arrival.kind == ArrivalKind::kEntry) entered_.push_back(i);
    be_sure_of(i, arrival.sure);
    return;
  }
  // Leaving the surface from rest and being back at once is rounding, and so is leaving it at a
  // speed that the flight does not have: the motion itself decides.
  const bool is_rounding = arrival.kind == ArrivalKind::kTouch
                               ? contact(i) == Contact::kDeparting
                               : multiplicity(i) > 1 && !(arrival.speed < -speed_rounding(i));
  if (arrival.flight == 0 && is_rounding && !(depth(i) > 0)) {
    if (arrival.kind == ArrivalKind::kContact) arrival.kind = ArrivalKind::kTouch;
    set(i, Contact::kLocked, 1);
    return;
  }
  // The force is zero here, whatever the rounded depth would give.
  if (contact(i) == Contact::kParted && arrival.kind == ArrivalKind::kEntry) {
    set(i, Contact::kCompressed, 1);
  } else if (arrival.below && depth(i) > 0) {
    set(i, Contact::kParted, 1);
  } else {
    // At the surface, from either side.
    settle_on(i, arrival.flight);
    if (arrival.kind == ArrivalKind::kContact) {
      arrival.kind = ArrivalKind::kTouch;
      set(i, Contact::kTouching);
    } else {
      set(i, arrival.speed < 0 ? Contact::kDeparting : Contact::kTouching,
          arrival.speed < 0 ? 1 : 0);
      // A dashpot that pulled up to this instant no longer does.
      if (arrival.kind == ArrivalKind::kSeparation && !stop(i).force().sets_in_smoothly())
        judge_again(Jumped::kForces);
    }
  }
}

// The flight that starts now is known not to meet the surface for so long, s.
template <class Real>
void Motion<Real>::be_sure_of(int i, const Real& time) {
  if (sure_.empty() || sure_speeds_ != now_.qdot) sure_.assign(stops_.size(), Real(0));
  sure_speeds_ = now_.qdot;
  sure_[static_cast<std::size_t>(i)] = time;
}

}  // namespace graze
