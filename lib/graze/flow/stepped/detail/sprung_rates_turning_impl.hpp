// Definitions of sprung_rates.hpp for a structure on a rotating hub.
#pragma once

#include "graze/flow/stepped/detail/sprung_rates_powers_impl.hpp"

namespace graze::step_walk {

// The speed of the motion, or the speed that the forces at the start give within the fastest
// oscillation; in the units of the springs where any is compressed.
inline void Sprung::set_turning_units(const Vector& velocity) {
  const TurningStructure& structure = system_.turning->structure;
  const double quickest = structure.highest_frequency();
  longest_step_ = std::fmin(longest_step_, 0.25 * kTurn / quickest);
  if (!contacts_.empty()) return;
  y_ = system_.turning->held + system_.turning->spread(from_);
  ydot_ = system_.turning->spread(velocity);
  const TurningMotion at{y_, ydot_};
  const Vector none = Vector::Zero(y_.size());
  const Vector push = structure.turning_force(at, 0.0).cwiseAbs() / quickest +
                      structure.force_rate(at, none).cwiseAbs() / (quickest * quickest);
  const Vector force = system_.turning->gathered(push).cwiseAbs();
  // The speed of coordinates with stiffness, if any moves: the rigid rotation may be much faster.
  double whole = 0.0;
  for (Eigen::Index j = 0; j < modes(); ++j) {
    const double stiffness = system_.stiffness(j, 0);
    const double size = std::fmax(std::abs(velocity[j]),
                                  std::fmax(force[j], stiffness * std::abs(from_[j]) / quickest));
    (stiffness > 0.0 ? unit_ : whole) = std::fmax(stiffness > 0.0 ? unit_ : whole, size);
  }
  if (!(unit_ > 0.0)) unit_ = whole;
}

inline void Sprung::spread(const State& z) {
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n), velocity(z.data() + n, n);
  const Turning& turning = *system_.turning;
  y_ = turning.held + turning.spread(from_ + unit_ * moved.cwiseQuotient(scale_));
  ydot_ = turning.spread(unit_ * velocity);
}

inline void Sprung::turn(double s, Eigen::Ref<Vector> acceleration, State& slope) {
  const TurningStructure& structure = system_.turning->structure;
  const TurningMotion at{y_, ydot_};
  Vector force = structure.turning_force(at, s);
  if (structure.rotation().damping.size() > 0) force -= structure.rotation().damping * ydot_;
  acceleration += system_.turning->gathered(force) / unit_;
  slope[place(kForcing)] = structure.torque_power(at, s) / work_unit_;
  slope[place(kWeight)] = structure.weight_power(at) / work_unit_;
  slope[place(kDissipation)] = structure.dissipation(at) / work_unit_;
  slope[place(kConstraint)] = 0.0;
}

inline void Sprung::add_inertia(Eigen::Ref<Vector> acceleration) const {
  const double m = system_.turning->structure.added_inertia(y_);
  if (m != 0.0)
    acceleration -= (m * angle_.dot(acceleration) / (1.0 + m * angle_.squaredNorm())) * angle_;
}

// The forces of the springs on all coordinates, N.
inline Vector Sprung::spring_push(const State& z) const {
  Vector push = Vector::Zero(y_.size());
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    if (system_.springs[i].loaded) push += force(i, z) * system_.springs[i].whole_row;
  return push;
}

inline double Sprung::hold_force(int hold, double s, const State& z) {
  spread(z);
  const Turning& turning = *system_.turning;
  return turning.hold_forces(turning.structure.force({y_, ydot_}, s) - spring_push(z), y_)[hold];
}

inline double Sprung::hold_rate(int hold, double s, const State& z) {
  const Turning& turning = *system_.turning;
  Vector push = Vector::Zero(turning.held.size());
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    if (system_.springs[i].loaded) push += force_rate(i, s, z) * system_.springs[i].whole_row;
  spread(z);
  const TurningMotion at{y_, ydot_};
  const Vector acceleration =
      turning.acceleration(turning.structure.force(at, s) - spring_push(z), y_);
  return turning.hold_rates(at, acceleration,
                            turning.structure.force_rate(at, acceleration) - push)[hold];
}

}  // namespace graze::step_walk
