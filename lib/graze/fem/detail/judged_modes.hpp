// What vectors are as modes of a structure: their frequencies, which of them are those of a rigid
// body, and how well they satisfy K phi = w^2 M phi.
#pragma once

#include <string>

#include "graze/fem/structural_matrices.hpp"

namespace graze {

// Of a mode; larger ones are refused.
inline constexpr double kLargestResidual = 1e-8;

// As of StructuralModes (structural_modes.hpp).
struct JudgedModes {
  Vector omega;
  Matrix shapes;
  Vector residuals, square_roundings;
  int rigid = 0;
};

// Of vectors that are orthonormal in M, n x m. Throws InputError where the stiffness is indefinite.
JudgedModes judged_modes(const StructuralMatrices& structure, const Matrix& vectors);

// By what twice the elastic energy of each column changes where every entry of the stiffness is
// rounded for itself.
Vector energy_roundings(const SparseMatrix& stiffness, const Matrix& columns);

[[noreturn]] void refuse_indefinite(const StructuralMatrices& structure, const std::string& why);

}  // namespace graze
