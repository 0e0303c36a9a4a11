// A real matrix split along its invariant subspaces as far as these can be told apart,
//
//   A = sum_k V_k T_k W_k,   W_j V_k = delta_jk I,
//
// each block with one real eigenvalue, a conjugate pair, or several of either that cannot be
// separated well: a defective matrix keeps its Jordan blocks together and lets go of the rest.
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

// `largest`: what an element of a decoupling transformation may be; its digits are lost. One block
// where the Schur form is not found.
std::vector<InvariantBlock> invariant_blocks(const Matrix& matrix, double largest);

}  // namespace graze
