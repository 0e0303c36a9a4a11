// The forces and the inertia of a structure on a rotating hub (system/rotation.hpp), at a state.
//
// The mass matrix is the identity and one dyad, so that its inverse is known: (I + m e e^T)^-1 h =
// h - e m (e.h)/(1 + m e.e), here on all coordinates or on those that are not held (turning.hpp).
// Rates are analytic, along the motion.
#pragma once

#include "graze/flow/exact/motion_state.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Displacements and velocities.
struct TurningMotion {
  const Vector& y;
  const Vector& velocity;
};

class TurningStructure {
 public:
  // Requires system.rotation(). Keeps copies.
  explicit TurningStructure(const System& system);

  // Sets the origin of s to `time`, s; the torque is that of the piece which begins there.
  void begin(double time);
  // How long the torque stays on that piece, s; infinite after the last.
  double smooth_for() const;
  void set_joint(Joint joint) { joint_ = joint; }

  const Rotation& rotation() const { return rotation_; }
  const Vector& angle_row() const { return rotation_.angle; }
  // Sum of all forces except -W^2 y and -D y', s seconds after begin(); and the sum of all forces.
  Vector turning_force(const TurningMotion& at, double s) const;
  Vector force(const TurningMotion& at, double s) const;
  // The rate of force(), where y'' = `acceleration`.
  Vector force_rate(const TurningMotion& at, const Vector& acceleration) const;
  // Sum of the sizes of the terms of force(), for its rounding.
  Vector force_size(const TurningMotion& at, double s) const;

  // y.A y, kg m^2 in units of the row, and its rate; 0 in the printed equations.
  double added_inertia(const Vector& y) const;
  double added_inertia_rate(const TurningMotion& at) const;
  // M^-1 f.
  Vector accelerated(const Vector& force, const Vector& y) const;

  // Rate of the hub, rad/s.
  double rate(const Vector& velocity) const { return rotation_.angle.dot(velocity); }
  // Whether the rate of the hub is within its rounding of zero.
  bool stands_still(const Vector& velocity) const;
  // Powers, W: of the torque, of the weight, and the loss by damping and friction.
  double torque_power(const TurningMotion& at, double s) const;
  double weight_power(const TurningMotion& at) const;
  double dissipation(const TurningMotion& at) const;
  // 1/2 y'.M y', J.
  double kinetic_energy(const TurningMotion& at) const;

  // Frequencies, rad/s: the highest, and the lowest that is not 0.
  double highest_frequency() const { return highest_; }
  double lowest_frequency() const { return lowest_; }

 private:
  double torque(double s) const { return torque_ + torque_rate_ * s; }
  double friction() const;
  bool stretches() const { return rotation_.stretch.size() > 0; }

  Vector stiffness_;  // W^2
  Rotation rotation_;
  double highest_ = 0.0, lowest_ = 0.0;
  Joint joint_ = Joint::kFree;
  double torque_ = 0.0, torque_rate_ = 0.0, smooth_for_ = 0.0;
};

}  // namespace graze
