#include "graze/structure/detail/strain_units.hpp"

#include <Eigen/Cholesky>

#include "graze/base/linalg/detail/products.hpp"

namespace graze {

using Eigen::Index;

StrainUnits::StrainUnits(const Line& line, const LineMesh& mesh) : order_(mesh.order()) {
  const Vector stiffness = mesh.weights(line).stiffness;
  const Matrix& strains = mesh.strains();
  for (Index e = 0; e < static_cast<Index>(mesh.elements().size()); ++e) {
    const auto weights = stiffness.segment(e * strains.rows(), strains.rows());
    const Matrix matrix = transposed_product<double>(weights.asDiagonal() * strains, strains);
    upper_.push_back(matrix.llt().matrixU());
  }
}

Matrix StrainUnits::scaled(Matrix rows) const {
  Index first = order_;
  for (const Matrix& upper : upper_) {
    auto block = rows.middleCols(first, upper.cols());
    upper.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(block);
    first += upper.cols();
  }
  return rows;
}

Matrix StrainUnits::unscaled(Matrix y) const {
  Index first = order_;
  for (const Matrix& upper : upper_) {
    auto block = y.middleRows(first, upper.cols());
    upper.triangularView<Eigen::Upper>().solveInPlace(block);
    first += upper.cols();
  }
  return y;
}

}  // namespace graze
