// A real matrix split along its invariant subspaces as far as these can be separated,
//
//   A = sum_k V_k T_k W_k,   W_j V_k = delta_jk I,
//
// each block with one real eigenvalue, a conjugate pair, or several of either that cannot be
// separated well: a defective matrix keeps the eigenvalues of a Jordan block together.
//
// The real Schur form is decoupled by Sylvester equations; blocks are joined where the solution is
// larger than allowed (C. A. Bavely, G. W. Stewart, SIAM J. Numer. Anal. 16 (1979) 359).
#pragma once

#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

struct InvariantBlock {
  Matrix matrix;       // T, k x k, real quasi-triangular
  Matrix basis;        // V, n x k
  Matrix coordinates;  // W, k x n
};

// `largest`: largest allowed modulus of an entry of a decoupling transformation, which amplifies
// rounding by as much. Returns a single block when the Schur form is not found.
std::vector<InvariantBlock> invariant_blocks(const Matrix& matrix, double largest);

}  // namespace graze
