// The periodic Schur form of a product M = A_k .. A_2 A_1 of square matrices: unitary Q_0 ..
// Q_{k-1} such that every
//
//   T_i = Q_i^* A_i Q_{i-1}    (Q_k = Q_0)
//
// is upper triangular. The eigenvalues of M are products of diagonal entries; M itself is never
// formed, so that each T_i belongs to an A_i changed by no more than a few roundings of its own
// norm, however large or small the other factors are.
//
// Method: periodic Hessenberg form by Householder reflections, implicit periodic QR steps with two
// shifts at a time, and one shift in complex arithmetic for the 2 x 2 blocks that remain.
// Bojanczyk, Golub and Van Dooren, Proc. SPIE 1770 (1992) 31-42; Hench and Laub, IEEE Trans. Autom.
// Control 39 (1994) 1197-1210; Kressner, BIT 41 (2001) 736-743. A singular factor is split off
// first: seen from its range it has zero rows, and these become exact zeros on the diagonal.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

struct PeriodicSchurForm {
  // Upper triangular, n x n each, in the order of the factors, but the first of them may be any
  // A_i: the eigenvalues of a product do not depend on where its cycle starts.
  std::vector<Eigen::MatrixXcd> factors;
  // Rows j where the eigenvalues j and j + 1 are a conjugate pair; all others are real.
  std::vector<Eigen::Index> pairs;
};

// k >= 2 real factors, n x n each, n >= 1, in the order in which they act, finite, their entries so
// scaled that squares of the leading ones neither overflow nor vanish. Returns nullopt when the
// iteration does not converge within 120 steps per eigenvalue, or was asked to stop
// (stop_scope.hpp).
std::optional<PeriodicSchurForm> periodic_schur(std::vector<Matrix> factors);

}  // namespace graze
