// Definitions of contact_phase.hpp: the joint of a hub with friction.
#pragma once

#include <limits>
#include <type_traits>

#include "graze/contact/impulse.hpp"
#include "graze/flow/contact_phase.hpp"

namespace graze {

// Roundings of an acceleration of a structure that turns, of the size of the forces that are
// summed.
inline constexpr double kRoundingsOfTurning = 16.0 * std::numeric_limits<double>::epsilon();

// A joint that is held is closed like a stop, but holds either way.
template <class Real>
System ContactPhase<Real>::with_joint_held(const System& system, double angle) const {
  System held = system;
  const Vector& row = system.rotation()->angle;
  held.stops.push_back({row, angle, ImpactLaw{momentum_direction(row)}});
  return held;
}

template <class Real>
void ContactPhase<Real>::watch_joint(double friction) {
  if constexpr (std::is_same_v<Real, double>) {
    Watch watch;
    watch.is_told = false;
    if (joint_ == Joint::kHeld) {
      watch.constant = friction;
      watch.of_spring = SpringWatch::kHold;
      watch.spring = static_cast<int>(holds_.size()) - 1;
      watch.factor = -1.0;
      joint_watches_.push_back(watch);
      watch.factor = 1.0;
      joint_watches_.push_back(watch);
      return;
    }
    if (joint_ == Joint::kFree) return;
    const Vector& row = sprung_->turning->structure.angle_row();
    const Vector free = basis_.size() > 0 ? Vector(basis_.transpose() * row) : row;
    watch.weights = Vector::Zero(2 * free.size());
    watch.weights.tail(free.size()) = joint_ == Joint::kForward ? free : Vector(-free);
    joint_watches_.push_back(watch);
  }
}

template <class Real>
const std::vector<Watch>& ContactPhase<Real>::joint_watches(int multiplicity, double departure) {
  if (joint_ == Joint::kForward || joint_ == Joint::kBackward) {
    joint_watches_.front().multiplicity = multiplicity;
    joint_watches_.front().departure = departure;
  }
  return joint_watches_;
}

template <class Real>
double ContactPhase<Real>::joint_torque_at_start() const {
  const Eigen::Index last = static_cast<Eigen::Index>(holds_.size()) - 1;
  return sprung_->turning->holds(at_start().force, start_q_)[last];
}

template <class Real>
CurvePoint<double> ContactPhase<Real>::hub_acceleration_at_start() const {
  const AtStart at = at_start();
  const TurningStructure& structure = sprung_->turning->structure;
  CurvePoint<double> point;
  point.value = structure.rate(at.acceleration);
  point.slope = structure.rate(at.jerk);
  point.noise = kRoundingsOfTurning * structure.angle_row().cwiseAbs().dot(
                                          structure.force_size({start_q_, start_qdot_}, 0.0));
  return point;
}

}  // namespace graze
