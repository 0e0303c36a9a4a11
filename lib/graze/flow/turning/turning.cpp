#include "graze/flow/turning/detail/turning.hpp"

namespace graze {

Vector Turning::acceleration(const Vector& force, const Vector& y) const {
  const Vector row = gathered(structure.angle_row()), free = gathered(force);
  const double m = structure.added_inertia(y);
  return spread(free - (m * row.dot(free) / (1.0 + m * row.squaredNorm())) * row);
}

Vector Turning::jerk(const TurningMotion& at, const Vector& acceleration,
                     const Vector& force_rate) const {
  const double change = structure.added_inertia_rate(at) * structure.rate(acceleration);
  return this->acceleration(force_rate - change * structure.angle_row(), at.y);
}

Vector Turning::hold_forces(const Vector& force, const Vector& y) const {
  const Vector moved = acceleration(force, y);
  return across * (force - moved -
                   (structure.added_inertia(y) * structure.rate(moved)) * structure.angle_row());
}

Vector Turning::hold_rates(const TurningMotion& at, const Vector& acceleration,
                           const Vector& force_rate) const {
  const Vector moved = jerk(at, acceleration, force_rate);
  const double along = structure.added_inertia(at.y) * structure.rate(moved) +
                       structure.added_inertia_rate(at) * structure.rate(acceleration);
  return across * (force_rate - moved - along * structure.angle_row());
}

}  // namespace graze
