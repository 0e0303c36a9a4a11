// A damping matrix in the modes of a structure.
#pragma once

#include "graze/fem/structural_modes.hpp"

namespace graze {

// Largest |C - a M - b K| relative to |C| (Frobenius), up to which damping counts as proportional.
inline constexpr double kProportional = 1e-8;

struct ModalDamping {
  Vector delta;  // decay rates, 1/s: half the diagonal of Phi^T C Phi
  bool is_proportional = false;
  double mass = 0.0, stiffness = 0.0;  // a in 1/s, b in s, if it is proportional
  // Else the largest off-diagonal entry of Phi^T C Phi, which couples two modes and is neglected,
  // relative to the geometric mean of both their diagonal entries; modes from 0 on.
  double coupling = 0.0;
  int first = 0, second = 0;
};

// For a structure with a damping matrix. Throws InputError where it adds energy to a mode.
ModalDamping modal_damping(const StructuralMatrices& structure, const StructuralModes& modes);

}  // namespace graze
