// Definitions of dense_factors.hpp; included by one translation unit per scalar.
#pragma once

#include <Eigen/QR>
#include <Eigen/SVD>

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

template <class Real>
RealMatrix<Real> orthonormal_columns(const RealMatrix<Real>& matrix, Eigen::Index count) {
  const Eigen::HouseholderQR<RealMatrix<Real>> factors(matrix);
  return factors.householderQ() * RealMatrix<Real>::Identity(matrix.rows(), count);
}

}  // namespace graze
