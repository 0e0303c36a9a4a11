// What vectors are as modes of a structure: their frequencies, which of them are those of a rigid
// body, and how well they satisfy K phi = w^2 M phi.
#pragma once

#include <string>

#include "graze/fem/structural_modes.hpp"

namespace graze {

// Of vectors that are orthonormal in M, n x m: sets all of `modes` that is one of each mode, and
// the number of rigid ones. Throws InputError where the stiffness is indefinite.
void judge(const StructuralMatrices& structure, const Matrix& vectors, StructuralModes& modes);

// By what twice the elastic energy of each column changes where every entry of the stiffness is
// rounded for itself.
Vector energy_roundings(const SparseMatrix& stiffness, const Matrix& columns);

[[noreturn]] void refuse_indefinite(const StructuralMatrices& structure, const std::string& why);

}  // namespace graze
