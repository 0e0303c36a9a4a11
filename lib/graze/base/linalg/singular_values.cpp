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
  const Matrix start = n <= kSmall
                           ? Matrix(Matrix::Identity(n, n))
                           : Matrix(symmetric_modes(transposed_product<double>(matrix, matrix))
                                        .vectors.rowwise()
                                        .reverse());
  dense_columns::OrthogonalColumns<double> columns(product<double>(matrix, start), start);
  columns.sweep_until_orthogonal();
  return columns.in_order();
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
