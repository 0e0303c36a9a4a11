// Products and factors of small matrices of 50 digits (products.hpp, dense_factors.hpp), in loops:
// what Eigen makes of them in this scalar took the compiler a minute, for matrices of a few rows.
#pragma once

#include <vector>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/flow/exact/extended.hpp"

namespace graze {

template <>
RealMatrix<Extended> product(const RealMatrix<Extended>& a, const RealMatrix<Extended>& b);
template <>
RealMatrix<Extended> transposed_product(const RealMatrix<Extended>& a,
                                        const RealMatrix<Extended>& b);
template <>
RealVector<Extended> image(const RealMatrix<Extended>& a, const RealVector<Extended>& x);
template <>
RealVector<Extended> transposed_image(const RealMatrix<Extended>& a, const RealVector<Extended>& x);

template <>
class PivotedLu<Extended> {
 public:
  explicit PivotedLu(const RealMatrix<Extended>& matrix);

  bool is_invertible() const { return rank_ == factors_.rows(); }
  RealVector<Extended> solve(const RealVector<Extended>& right) const;
  RealMatrix<Extended> inverse() const;

 private:
  using Index = Eigen::Index;
  void exchange(Index step, Index row, Index column);

  RealMatrix<Extended> factors_;       // L below the diagonal, U from it on
  std::vector<Index> rows_, columns_;  // of the matrix, in the order of the factors'
  Index rank_ = 0;                     // pivots that their rounding does not explain
};

// By rotations of columns (M. R. Hestenes, J. SIAM 6 (1958) 51-90). U is zero where a value is.
template <>
SingularValues<Extended> singular_values(const RealMatrix<Extended>& matrix);

template <>
RealMatrix<Extended> orthonormal_columns(const RealMatrix<Extended>& matrix, Eigen::Index count);

}  // namespace graze
