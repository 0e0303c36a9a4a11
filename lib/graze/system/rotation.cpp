#include "graze/system/rotation.hpp"

namespace graze {

double added_inertia(const Rotation& rotation, const Vector& y) {
  return rotation.stretch.size() > 0 && rotation.consistent ? y.dot(rotation.stretch * y) : 0.0;
}

double mobility(const Rotation& rotation, const Vector& row, const Vector& y) {
  const double m = added_inertia(rotation, y), along = rotation.angle.dot(row);
  return row.squaredNorm() - m * along * along / (1.0 + m * rotation.angle.squaredNorm());
}

}  // namespace graze
