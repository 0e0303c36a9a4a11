// The contact force on a stop while the structure is held on its stops for ever.
//
// With W = diag(omega), C = diag(2 delta), B the rows, D the directions and a the gaps of the
// closed stops, it answers the forcing by q = q_0 + Re(Q e^{i theta}), and the forces, over the
// effective masses, are f_0 + Re(F e^{i theta}):
//
//   W^2 q_0 + D f_0 = load,     (W^2 - Omega^2 + i Omega C) Q + D F = amplitude,
//   B^T q_0 = a,                 B^T Q = 0.
//
// The structure stays at rest where f_0 - |F| >= 0 at every closed stop.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "graze/system/system.hpp"

namespace graze {

struct HeldForce {
  double mean = 0.0;  // f_0, m/s^2
  Complex swing;      // F, m/s^2

  double least() const { return mean - std::abs(swing); }
  double phase_of_least() const;  // in [0, 2 pi), rad
};

// The force on `stop`, one of the closed ones. Nothing where the held structure is in resonance
// without damping. Requires forcing.
std::optional<HeldForce> held_force(const System& system, const std::vector<int>& closed, int stop);

}  // namespace graze
