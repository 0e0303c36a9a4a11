// Factors of small matrices of either scalar of a motion, double and 50 digits, in loops: what
// Eigen makes of them takes the compiler up to a minute. Each scalar's are compiled once (the
// implementation is in dense_factors_impl.hpp). A product of two columns of 400 numbers of 50
// digits takes some 20 us: every loop over them asks whether its time is over (stop_scope.hpp), and
// what it leaves then is of no use to anyone.
#pragma once

#include <vector>

#include "graze/base/vector.hpp"

namespace graze {

// P A Q = L U of a square matrix A, rows and columns exchanged.
template <class Real>
class PivotedLu {
 public:
  explicit PivotedLu(const RealMatrix<Real>& matrix);

  bool is_invertible() const { return rank_ == factors_.rows(); }  // to rounding
  // x of A x = right; of a singular A one that leaves as little as the pivots show.
  RealVector<Real> solve(const RealVector<Real>& right) const;
  RealMatrix<Real> inverse() const;

 private:
  using Index = Eigen::Index;
  void exchange(Index step, Index row, Index column);

  RealMatrix<Real> factors_;           // L below the diagonal, U from it on
  std::vector<Index> rows_, columns_;  // of the matrix, in the order of the factors'
  Index rank_ = 0;                     // pivots that their rounding does not explain
};

// A = U diag(values) V^T of a matrix of at least as many rows as columns, the values falling; U and
// V have as many columns as A has, those of U are zero where a value is.
template <class Real>
struct SingularValues {
  RealMatrix<Real> left;  // U
  RealVector<Real> values;
  RealMatrix<Real> right;  // V
};

// By rotations of columns (M. R. Hestenes, J. SIAM 6 (1958) 51-90): where each column has one size,
// the small values come out as exactly as the large ones.
template <class Real>
SingularValues<Real> singular_values(const RealMatrix<Real>& matrix);
template <>
SingularValues<double> singular_values(const Matrix& matrix);

// Values and right vectors alone (U stays empty). A large matrix by divide and conquer, whose values
// have an error of about eps times the largest one.
SingularValues<double> right_singular_vectors(const Matrix& matrix);

// The first `count` columns of an orthogonal matrix whose first k columns span those of `matrix`
// (n x k, independent): n x count, k <= count <= n.
template <class Real>
RealMatrix<Real> orthonormal_columns(const RealMatrix<Real>& matrix, Eigen::Index count);

}  // namespace graze
