// The real Schur form of a Hessenberg matrix without its basis: eigenvalues along the diagonal,
// complex pairs in blocks of two.
//
// Francis's QR iteration with double shifts (Golub and Van Loan, Matrix Computations, 4th ed.,
// section 7.5). Written for the small matrices that a continuation asks for at every point: in
// place, nothing allocated, and where only eigenvalues are wanted nothing is done outside the block
// that is worked on. Either way the diagonal blocks are the same to the last bit.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

enum class SchurPart { kDiagonalBlocks, kWhole };

// Overwrites a Hessenberg matrix, exactly zero below its first subdiagonal, by its quasi-triangular
// form, exactly zero below the diagonal blocks; blocks of two have complex eigenvalues. With
// kDiagonalBlocks only these are right. False when the iteration does not converge or an entry is
// not finite.
bool reduce_to_schur_form(Eigen::Ref<Matrix> hessenberg, SchurPart part);

}  // namespace graze
