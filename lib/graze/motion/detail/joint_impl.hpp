// Definitions of motion.hpp: the joint of a hub with Coulomb friction.
//
//   forward, backward: it rotates, against the whole of the friction, until its rate is zero;
//   held: it is at rest while the torque on it, f, is no more than the friction.
//
// An impulse is over before friction can act: an impact rotates a joint that is held.
#pragma once

#include <cmath>

#include "graze/motion/detail/motion.hpp"

namespace graze {

template <class Real>
void Motion<Real>::set_joint(Joint joint) {
  if (now_.joint == joint && joint != Joint::kHeld) return;
  now_.joint = joint;
  phase_ = nullptr;
  turning_->set_joint(joint);
  // Phases with a held joint are for its old angle.
  if (joint == Joint::kHeld)
    std::erase_if(phases_, [](const auto& entry) { return entry.first.joint == Joint::kHeld; });
}

// Called after anything that may have changed the rate.
template <class Real>
void Motion<Real>::look_at_joint() {
  if (!has_friction()) return;
  if (!turning_->stands_still(now_.qdot.template cast<double>()))
    set_joint(hub_rate(now_.qdot) > 0 ? Joint::kForward : Joint::kBackward);
  else if (now_.joint != Joint::kHeld)
    stop_joint();
}

// At rest the joint is held, unless the torque exceeds the friction.
template <class Real>
void Motion<Real>::stop_joint() {
  using std::abs;
  const RealVector<Real> row = turning_->angle_row().template cast<Real>();
  const RealVector<Real> along = accelerated(row);
  now_.qdot -= (row.dot(now_.qdot) / row.dot(along)) * along;
  set_joint(Joint::kHeld);
  const Real torque =
      start_phase().force_at(static_cast<int>(stops_.size()), Real(0), now_.q, now_.qdot);
  if (abs(torque) > *system_.rotation()->friction)
    set_joint(torque > 0 ? Joint::kForward : Joint::kBackward);
}

// Rate of the hub, rad/s; with accelerations its angular acceleration.
template <class Real>
Real Motion<Real>::hub_rate(const RealVector<Real>& rates) const {
  return turning_->angle_row().template cast<Real>().dot(rates);
}

// `forward`: the torque on a held joint exceeds the friction in that direction.
template <class Real>
void Motion<Real>::arrive_at_joint(bool forward) {
  if (now_.joint == Joint::kHeld)
    set_joint(forward ? Joint::kForward : Joint::kBackward);
  else
    stop_joint();
}

}  // namespace graze
