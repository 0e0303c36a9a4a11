// Definitions of dense_factors.hpp; included by one translation unit per scalar.
#pragma once

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

#include "graze/base/linalg/detail/dense_factors.hpp"

namespace graze {

template <class Real>
PivotedLu<Real>::PivotedLu(const RealMatrix<Real>& matrix) : factors_(matrix) {}

template <class Real>
bool PivotedLu<Real>::is_invertible() const {
  return factors_.isInvertible();
}

template <class Real>
RealVector<Real> PivotedLu<Real>::solve(const RealVector<Real>& right) const {
  return factors_.solve(right);
}

template <class Real>
RealMatrix<Real> PivotedLu<Real>::inverse() const {
  return factors_.inverse();
}

template <class Real>
SingularValues<Real> singular_values(const RealMatrix<Real>& matrix) {
  const Eigen::JacobiSVD<RealMatrix<Real>> factors(matrix,
                                                   Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {factors.matrixU(), factors.singularValues(), factors.matrixV()};
}

// A reflection after the other: Eigen's steps of several columns at once are for large matrices,
// and to compile them takes as long as all the rest of this file.
template <class Real>
RealMatrix<Real> orthonormal_columns(const RealMatrix<Real>& matrix, Eigen::Index count) {
  using Eigen::Index;
  RealMatrix<Real> factors = matrix;
  const Index rows = matrix.rows(), size = std::min(rows, matrix.cols());
  RealVector<Real> tau(size), work(std::max(matrix.cols(), count));
  for (Index k = 0; k < size; ++k) {
    Real left = 0;
    factors.col(k).tail(rows - k).makeHouseholderInPlace(tau[k], left);
    factors(k, k) = left;
    factors.bottomRightCorner(rows - k, matrix.cols() - k - 1)
        .applyHouseholderOnTheLeft(factors.col(k).tail(rows - k - 1), tau[k], work.data());
  }
  RealMatrix<Real> columns = RealMatrix<Real>::Identity(rows, count);
  for (Index k = size; k-- > 0;)
    columns.bottomRows(rows - k).applyHouseholderOnTheLeft(factors.col(k).tail(rows - k - 1),
                                                           tau[k], work.data());
  return columns;
}

}  // namespace graze
