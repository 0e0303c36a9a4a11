#include "graze/structure/detail/moving_supports.hpp"

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/structure/detail/line_conditions.hpp"
#include "graze/structure/detail/strain_units.hpp"

namespace graze {

using Eigen::Index;

MovingSupports::MovingSupports(const Line& line, const LineMesh& mesh) : line_(line), mesh_(mesh) {
  std::vector<LineCondition> conditions = conditions_of(line, mesh);
  std::erase_if(conditions, [](const LineCondition& one) { return !one.is_rigid(); });
  const auto count = static_cast<Index>(conditions.size());
  Matrix held(count, mesh.unknowns());
  rate_ = held;
  const RatedRows values = mesh.values_at_nodes(true);
  const RatedRows slopes = line.order == 2 ? mesh.slopes_at_nodes(true) : values;
  for (Index k = 0; k < count; ++k) {
    const LineCondition& one = conditions[static_cast<std::size_t>(k)];
    const RatedRows& from = one.on_slope ? slopes : values;
    const double scale = one.on_slope ? line.length.value : 1.0;
    held.row(k) = scale * from.value.row(static_cast<Index>(one.node));
    rate_.row(k) = scale * from.rate.row(static_cast<Index>(one.node));
  }
  if (count == 0 || rate_.isZero(0.0)) return;
  Matrix rows = StrainUnits(line, mesh).scaled(held);
  const Index order = line.order;
  unit_ = rows.rightCols(rows.cols() - order).norm() / rows.leftCols(order).norm();
  rows.leftCols(order) *= unit_;
  basis_ = orthonormal_columns<double>(rows.transpose(), count);
  across_.emplace((basis_.transpose() * rows.transpose()).eval());
}

Matrix MovingSupports::reactions(const Matrix& forces) const {
  Matrix left = StrainUnits(line_, mesh_).scaled(forces.transpose());
  left.leftCols(line_.order) *= unit_;
  return across_->solve_columns(product<double>(left, basis_).transpose());
}

Matrix MovingSupports::following(const Matrix& moved) const {
  Matrix asked(moved.rows(), moved.cols());
  for (Index j = 0; j < asked.cols(); ++j) asked.col(j) = -across_->solve_transposed(moved.col(j));
  Matrix y = basis_ * asked;
  y.topRows(line_.order) *= unit_;
  return StrainUnits(line_, mesh_).unscaled(y);
}

}  // namespace graze
