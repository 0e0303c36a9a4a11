// What a rotating hub adds to the structure fixed to it (A. S. Yigit, A. G. Ulsoy, R. A. Scott,
// J. Sound Vib. 137, 1990; made consistent). In the coordinates y of the modes of hub and beam
// together, small angles or large:
//
//   M y'' = -W^2 y - D y' + r^2 A y - 2 r (y'.A y) e + (T(t) - friction) e - grad V - sum row F,
//   M = I + (y.A y) e e^T,   angle = e.y,   r = e.y',   V = moment sin(angle) + pull.y cos(angle).
//
// The printed pair has M = I and leaves out the term with y'.A y. What is absent is left out.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

// Torque over time, linear between its points and zero outside; it jumps where an instant is given
// twice.
struct TorqueHistory {
  std::vector<double> times;   // s, ascending
  std::vector<double> values;  // N m
};

struct WeightOnHub {
  double moment = 0.0;  // of the straight beam at angle 0, N m
  Vector pull;          // kg^1/2 m/s^2, n
};

struct Rotation {
  Vector angle;            // e, kg^-1/2 m^-1, n
  Matrix beam;             // the beam's own modal coordinates: N x n, q = beam y
  Matrix damping{};        // D, 1/s, n x n; empty: none
  Matrix stretch{};        // A, 1, n x n; empty: no centrifugal terms
  bool consistent = true;  // else the printed pair
  std::optional<WeightOnHub> weight{};
  std::optional<TorqueHistory> torque{};
  std::optional<double> friction{};  // Coulomb's at the joint, N m
};

// y.A y where it adds to the inertia, else 0.
double added_inertia(const Rotation& rotation, const Vector& y);

// row.M^-1 row at y, 1/kg for the row of a stop.
double mobility(const Rotation& rotation, const Vector& row, const Vector& y);

}  // namespace graze
