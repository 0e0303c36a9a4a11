// Improves approximate eigenvectors to the accuracy that rounding allows.
#pragma once

#include "graze/fem/labelled_matrix.hpp"

namespace graze {

// Makes the columns orthonormal in M: V becomes V L^-T with V^T M V = L L^T. False where they are
// not independent.
bool orthonormalise(const SparseMatrix& mass, Matrix& vectors);

// Rotates the columns until A = V^T S V is diagonal (Jacobi's method). Unlike a reduction to
// tridiagonal form it gives each eigenvalue of a positive definite A its own relative accuracy, so
// that the lowest ones lose no digits to the highest (Demmel & Veselic, SIAM J. Matrix Anal. Appl.
// 13 (1992) 1204).
void diagonalise(const SparseMatrix& matrix, Matrix& vectors);

}  // namespace graze
