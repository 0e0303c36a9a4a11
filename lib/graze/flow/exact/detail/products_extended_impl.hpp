// Definitions of products_extended.hpp; included by one translation unit. Loops over columns ask
// whether their time is over, as those of dense_factors.hpp do.
#pragma once

#include "graze/base/stop_scope.hpp"
#include "graze/flow/exact/detail/products_extended.hpp"

namespace graze {

template <>
RealMatrix<Extended> product(const RealMatrix<Extended>& a, const RealMatrix<Extended>& b) {
  RealMatrix<Extended> c = RealMatrix<Extended>::Zero(a.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index k = 0; k < b.rows() && !StopScope::is_over(); ++k)
      for (Eigen::Index i = 0; i < a.rows(); ++i) c(i, j) += a(i, k) * b(k, j);
  return c;
}

template <>
RealMatrix<Extended> transposed_product(const RealMatrix<Extended>& a,
                                        const RealMatrix<Extended>& b) {
  RealMatrix<Extended> c = RealMatrix<Extended>::Zero(a.cols(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index i = 0; i < a.cols() && !StopScope::is_over(); ++i)
      for (Eigen::Index k = 0; k < a.rows(); ++k) c(i, j) += a(k, i) * b(k, j);
  return c;
}

template <>
RealVector<Extended> image(const RealMatrix<Extended>& a, const RealVector<Extended>& x) {
  RealVector<Extended> y = RealVector<Extended>::Zero(a.rows());
  for (Eigen::Index k = 0; k < x.size(); ++k)
    for (Eigen::Index i = 0; i < a.rows(); ++i) y[i] += a(i, k) * x[k];
  return y;
}

template <>
RealVector<Extended> transposed_image(const RealMatrix<Extended>& a,
                                      const RealVector<Extended>& x) {
  RealVector<Extended> y = RealVector<Extended>::Zero(a.cols());
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    for (Eigen::Index k = 0; k < x.size(); ++k) y[j] += a(k, j) * x[k];
  return y;
}

}  // namespace graze
