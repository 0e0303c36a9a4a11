// Factors of small matrices of either scalar of a motion, double and 50 digits. What Eigen makes of
// one takes seconds of compile time in every file that forms it, so each scalar's are compiled once
// (the implementation is in dense_factors_impl.hpp).
#pragma once

#include <Eigen/LU>

#include "graze/base/vector.hpp"

namespace graze {

// P A Q = L U of a square matrix A, rows and columns exchanged.
template <class Real>
class PivotedLu {
 public:
  explicit PivotedLu(const RealMatrix<Real>& matrix);

  bool is_invertible() const;  // to the rounding of the elimination
  // x of A x = right; of a singular A one that leaves as little as the pivots show.
  RealVector<Real> solve(const RealVector<Real>& right) const;
  RealMatrix<Real> inverse() const;

 private:
  Eigen::FullPivLU<RealMatrix<Real>> factors_;
};

// A = U diag(values) V^T, the values falling; U and V have as many columns as there are values.
template <class Real>
struct SingularValues {
  RealMatrix<Real> left;  // U
  RealVector<Real> values;
  RealMatrix<Real> right;  // V
};

// By Jacobi's method: where each column has one size, the small values come out as exactly as the
// large ones.
template <class Real>
SingularValues<Real> singular_values(const RealMatrix<Real>& matrix);

// Values and right vectors alone (U stays empty) of a matrix of at least as many rows as columns. A
// large one by divide and conquer, whose values have an error of about eps times the largest one.
SingularValues<double> right_singular_vectors(const RealMatrix<double>& matrix);

// The first `count` columns of an orthogonal matrix whose first k columns span those of `matrix`
// (n x k, independent): n x count, k <= count <= n.
template <class Real>
RealMatrix<Real> orthonormal_columns(const RealMatrix<Real>& matrix, Eigen::Index count);

}  // namespace graze
