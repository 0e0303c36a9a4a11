// The accuracy of vectors as modes of a structure: their frequencies, which of them are rigid-body
// modes, and how well they satisfy K phi = w^2 M phi.
#pragma once

#include <string>

#include "graze/fem/structural_matrices.hpp"

namespace graze {

// Largest residual of a mode that is accepted.
inline constexpr double kLargestResidual = 1e-8;

// The members have the meaning of those of StructuralModes (structural_modes.hpp).
struct JudgedModes {
  Vector omega;
  Matrix shapes;
  Vector residuals, square_roundings;
  int rigid = 0;
};

// For vectors that are orthonormal in M, n x m. Throws InputError where the stiffness is
// indefinite.
JudgedModes judged_modes(const StructuralMatrices& structure, const Matrix& vectors);

// Change of twice the elastic energy of each column by independent rounding of every entry of the
// stiffness.
Vector energy_roundings(const SparseMatrix& stiffness, const Matrix& columns);

[[noreturn]] void refuse_indefinite(const StructuralMatrices& structure, const std::string& why);

}  // namespace graze
