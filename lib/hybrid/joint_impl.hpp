// Definitions of motion.hpp: the joint of a hub with Coulomb friction.
//
//   forward, backward: it turns, against the whole of the friction, until its rate is zero;
//   held: it stands still while what would turn it, f, is no more than the friction.
//
// An impulse is over before friction can act: an impact turns a joint that is held.
#pragma once

#include <cmath>
#include <type_traits>

#include "graze/hybrid/motion.hpp"

namespace graze {

namespace joint_detail {

// No rate but the rounding of what it is made of.
inline bool stands_still(const TurningStructure& turning, const Vector& qdot) {
  const double rounding = impact_detail::kRoundings * std::numeric_limits<double>::epsilon() *
                          turning.angle_row().cwiseAbs().dot(qdot.cwiseAbs());
  return std::abs(turning.rate(qdot)) <= rounding;
}

}  // namespace joint_detail

template <class Real>
void Motion<Real>::set_joint(Joint joint) {
  if (now_.joint == joint && joint != Joint::kHeld) return;
  now_.joint = joint;
  phase_ = nullptr;
  if constexpr (std::is_same_v<Real, double>) turning_->set_joint(joint);
  // Where it is held now it was not before: at another angle.
  if (joint == Joint::kHeld)
    std::erase_if(phases_, [](const auto& entry) { return entry.first.joint == Joint::kHeld; });
}

// After what may have changed the rate.
template <class Real>
void Motion<Real>::look_at_joint() {
  if constexpr (std::is_same_v<Real, double>) {
    if (!has_friction()) return;
    if (!joint_detail::stands_still(*turning_, now_.qdot))
      set_joint(turning_->rate(now_.qdot) > 0.0 ? Joint::kForward : Joint::kBackward);
    else if (now_.joint != Joint::kHeld)
      stop_joint();
  }
}

// At a standstill: held, unless more than the friction turns it.
template <class Real>
void Motion<Real>::stop_joint() {
  if constexpr (std::is_same_v<Real, double>) {
    const Vector& row = turning_->angle_row();
    const Vector along = turning_->accelerated(row, now_.q);
    now_.qdot -= (turning_->rate(now_.qdot) / row.dot(along)) * along;
    set_joint(Joint::kHeld);
    const double torque = start_phase().joint_torque_at_start();
    if (std::abs(torque) > *system_.rotation()->friction)
      set_joint(torque > 0.0 ? Joint::kForward : Joint::kBackward);
  }
}

template <class Real>
void Motion<Real>::watch_joint(ContactPhase<Real>& phase, std::vector<Watched>& list) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (!has_friction()) return;
    int multiplicity = 0;
    double departure = 0.0;
    if (now_.joint != Joint::kHeld && joint_detail::stands_still(*turning_, now_.qdot)) {
      const CurvePoint<double> turned = phase.hub_acceleration_at_start();
      const double sign = now_.joint == Joint::kForward ? 1.0 : -1.0;
      multiplicity = std::abs(turned.value) > turned.noise ? 1 : 2;
      departure = sign * (multiplicity == 1 ? turned.value : 0.5 * turned.slope);
    }
    for (const Watch& watch : phase.joint_watches(multiplicity, departure))
      list.push_back({kJoint, &watch, ArrivalKind::kJoint});
  }
}

// `forward`: what is left of the friction of a held joint against that is gone.
template <class Real>
void Motion<Real>::arrive_at_joint(bool forward) {
  if (now_.joint == Joint::kHeld)
    set_joint(forward ? Joint::kForward : Joint::kBackward);
  else
    stop_joint();
}

}  // namespace graze
