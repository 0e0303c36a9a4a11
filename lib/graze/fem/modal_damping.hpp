// A damping matrix in the modes of a structure.
#pragma once

#include "graze/fem/structural_modes.hpp"

namespace graze {

// Largest |C - a M - b K| relative to |C| (Frobenius), up to which damping counts as proportional.
inline constexpr double kProportional = 1e-8;

// The same where the entries have all digits of double: some roundings of each.
inline constexpr double kProportionalExactly = 1e-13;

struct ModalDamping {
  Vector delta;  // decay rates, 1/s: half the diagonal of Phi^T C Phi
  bool is_proportional = false;
  double mass = 0.0, stiffness = 0.0;  // a in 1/s, b in s, if it is proportional
  // Phi^T C Phi without its diagonal, 1/s: forces -coupling q'. Empty where it is zero to rounding,
  // so that each mode moves by itself.
  Matrix coupling;
};

// For a structure with a damping matrix. `proportional`: one of the limits above. Throws InputError
// where some motion takes energy from it.
ModalDamping modal_damping(const StructuralMatrices& structure, const StructuralModes& modes,
                           double proportional = kProportional);

}  // namespace graze
