#include <Eigen/SVD>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/dense_factors_impl.hpp"
#include "graze/base/linalg/detail/products.hpp"

namespace graze {

// The rotations of a large matrix begin from columns that are nearly orthogonal, images of the
// eigenvectors of A^T A: two or three sweeps in place of ten.
template <>
SingularValues<double> singular_values(const Matrix& matrix) {
  constexpr Eigen::Index kSmall = 32;
  const Eigen::Index n = matrix.cols();
  if (n <= kSmall) return dense_columns::by_rotations<double>(matrix, Matrix::Identity(n, n));
  const Matrix start =
      symmetric_modes(transposed_product<double>(matrix, matrix)).vectors.rowwise().reverse();
  return dense_columns::by_rotations<double>(product<double>(matrix, start), start);
}

SingularValues<double> right_singular_vectors(const Matrix& matrix) {
  // Rotations take a few milliseconds for that many.
  constexpr Eigen::Index kSmall = 64;
  if (matrix.cols() <= kSmall) {
    SingularValues<double> all = singular_values<double>(matrix);
    return {{}, all.values, all.right};
  }
  const Eigen::BDCSVD<Matrix> factors(matrix, Eigen::ComputeThinV);
  return {{}, factors.singularValues(), factors.matrixV()};
}

}  // namespace graze
