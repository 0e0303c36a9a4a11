// A structure on a rotating hub and its constraints: closed stops, and a joint that does not slip.
//
// Held displacements are y_c + U x with orthonormal columns U across the rows B of the constraints;
// the constraint forces f act along B:
//
//   U^T M U x'' = U^T h,   M y'' = h - B f   =>   f = (B^T B)^-1 B^T (h - M y'')
//
// with h the sum of all other forces (turning_structure.hpp).
#pragma once

#include "graze/flow/turning/detail/turning_structure.hpp"

namespace graze {

struct Turning {
  TurningStructure structure;
  Vector held;    // y_c, n
  Matrix basis;   // U, n x free; empty: all are
  Matrix across;  // (B^T B)^-1 B^T, k x n; empty: nothing is held

  Vector spread(const Vector& x) const { return basis.size() > 0 ? Vector(basis * x) : x; }
  Vector gathered(const Vector& whole) const {
    return basis.size() > 0 ? Vector(basis.transpose() * whole) : whole;
  }
  // y'' under the forces h at y, and its rate where h has the rate force_rate along the motion.
  Vector acceleration(const Vector& force, const Vector& y) const;
  Vector jerk(const TurningMotion& at, const Vector& acceleration, const Vector& force_rate) const;
  // f, N, in the order of the rows; and f'.
  Vector hold_forces(const Vector& force, const Vector& y) const;
  Vector hold_rates(const TurningMotion& at, const Vector& acceleration,
                    const Vector& force_rate) const;
};

}  // namespace graze
