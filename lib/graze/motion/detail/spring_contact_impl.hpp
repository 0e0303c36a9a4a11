// Definitions of motion.hpp: compliant stops.
//
//   clear -> touching -> compressed -> departing -> clear
//                            | ^
//                            v |   force gone beyond the surface, and back
//                           parted -> departing
//
// Nothing jumps: an entry or a separation changes which forces act, and begins a new phase.
#pragma once

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
  }
  return springs;
}

// Beyond the surface, m; zero within the rounding of the gap.
template <class Real>
Real Motion<Real>::depth(int i) const {
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
    acceleration -= force * stop(i).row;
    if (size) *size += abs(force) * stop(i).row.cwiseAbs();
  }
}

// Where the motion starts beyond a surface the spring acts from there.
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

// The velocities have jumped at this instant, or the force of a spring has: every other contact is
// judged again. Springs by their forces, which velocities change, here; what touches a surface, and
// what closed stops hold, by decide().
template <class Real>
void Motion<Real>::judge_again(Jumped what) {
  for (const int i : compliant_) {
    const Contact before = contact(i);
    const bool rests =
        before == Contact::kLocked ||
        (before == Contact::kDeparting && now_.multiplicities[static_cast<std::size_t>(i)] > 1);
    if (rests || (before == Contact::kDeparting && what == Jumped::kVelocities))
      set(i, Contact::kTouching);
    if (what == Jumped::kForces || !stop(i).force().parts_early()) continue;
    // At its surface the next phase says whether it is left.
    if ((before != Contact::kCompressed && before != Contact::kParted) || !(depth(i) > 0)) continue;
    compress(i);
    if (contact(i) != before)
      changes_.push_back(
          {before == Contact::kParted ? ArrivalKind::kEntry : ArrivalKind::kSeparation, i});
  }
  if (is_closed_anywhere()) undecided_ = recheck_ = true;
}

// Of those touched: approached or pushed they are entered, else they are left. Those at rest last:
// what is entered may push them.
template <class Real>
void Motion<Real>::decide_springs() {
  const auto enter = [&](int i) {
    compress(i);
    changes_.push_back({ArrivalKind::kEntry, i});
  };
  for (const int i : compliant_) {
    if (contact(i) != Contact::kTouching) continue;
    const Real speed = approach_speed(i), rounding = speed_rounding(i);
    if (speed < -rounding) {
      set(i, Contact::kDeparting, 1);
    } else if (speed > rounding) {
      enter(i);
      if (!stop(i).force().sets_in_smoothly()) judge_again(Jumped::kForces);
    }
  }
  for (const int i : compliant_) {
    if (contact(i) != Contact::kTouching) continue;
    const std::optional<int> departs = departure_from_rest(i);
    if (!departs || *departs > 0)
      set(i, departs ? Contact::kDeparting : Contact::kLocked, departs.value_or(0));
    else
      enter(i);
  }
}

// At rest on a surface: how its gap grows, as s^2 or s^3; 0: it is pushed beyond. Where neither
// push nor its rate says, nothing moves it: it stays there until something does.
template <class Real>
std::optional<int> Motion<Real>::departure_from_rest(int i) {
  using std::abs;
  RealVector<Real> size;
  free_acceleration(&size);
  const Real push = free_push(i);
  if (abs(push) > push_rounding(i, size)) return push < 0 ? 2 : 0;
  const CurvePoint<Real> jerk = start_phase().gap_rate(i, 3);
  if (!(abs(jerk.value) > jerk.noise)) return {};
  return jerk.value < 0 ? 0 : 3;
}

// The located instant is rounded; what was reached there is not.
template <class Real>
void Motion<Real>::arrive_at_spring(Arrival<Real>& arrival) {
  const int i = arrival.stop;
  arrival.speed = approach_speed(i);
  // The force is zero here, whatever it comes to from the rounded depth.
  if (contact(i) == Contact::kParted && arrival.kind == ArrivalKind::kEntry) {
    set(i, Contact::kCompressed, 1);
  } else if (arrival.below && depth(i) > 0) {
    set(i, Contact::kParted, 1);
  } else {
    // The surface, from either side.
    settle_on(i, arrival.flight);
    if (arrival.kind == ArrivalKind::kContact) {
      arrival.kind = ArrivalKind::kTouch;
      set(i, Contact::kTouching);
    } else {
      set(i, arrival.speed < 0 ? Contact::kDeparting : Contact::kTouching,
          arrival.speed < 0 ? 1 : 0);
      // What pulled to the last does so no longer.
      if (arrival.kind == ArrivalKind::kSeparation && !stop(i).force().sets_in_smoothly())
        judge_again(Jumped::kForces);
    }
  }
  phase_ = nullptr;
}

}  // namespace graze
