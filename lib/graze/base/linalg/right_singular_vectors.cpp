#include <Eigen/SVD>

#include "graze/base/linalg/detail/dense_factors.hpp"

namespace graze {

SingularValues<double> right_singular_vectors(const RealMatrix<double>& matrix) {
  // Jacobi's method takes a few milliseconds for that many.
  constexpr Eigen::Index kSmall = 64;
  if (matrix.cols() <= kSmall) {
    SingularValues<double> all = singular_values<double>(matrix);
    return {{}, all.values, all.right};
  }
  const Eigen::BDCSVD<RealMatrix<double>> factors(matrix, Eigen::ComputeThinV);
  return {{}, factors.singularValues(), factors.matrixV()};
}

}  // namespace graze
