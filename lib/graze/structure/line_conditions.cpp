#include "graze/structure/detail/line_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/linalg/detail/products.hpp"

namespace graze {
using Eigen::Index;

std::vector<LineCondition> conditions_of(const Line& line, const LineMesh& mesh) {
  std::vector<LineCondition> all;
  const auto add = [&](double x, bool on_slope, double flexibility) {
    const LineCondition made{mesh.node(x), x, on_slope, flexibility};
    const bool again =
        made.is_rigid() && std::any_of(all.begin(), all.end(), [&](const LineCondition& other) {
          return other.node == made.node && other.on_slope == on_slope;
        });
    if (!again) all.push_back(made);
  };
  for (const LineSupport& support : line.supports) {
    if (support.holds_value) add(support.x.value, false, -1.0);
    if (support.holds_slope) add(support.x.value, true, -1.0);
  }
  for (const LineSpring& spring : line.springs)
    add(spring.x.value, spring.on_slope, 1.0 / std::sqrt(spring.stiffness.value));
  return all;
}

LineConditions::LineConditions(const Line& line, const LineMesh& mesh, const Matrix& values,
                               const Matrix& slopes)
    : order_(line.order) {
  const std::vector<LineCondition> all = conditions_of(line, mesh);
  const double length = line.length.value;
  const Index strains = values.cols() - order_;
  for (const LineCondition& condition : all)
    if (!condition.is_rigid()) ++springs_;
  unknowns_ = strains + springs_;
  choose_rigid(line, all);
  const auto count = static_cast<Index>(all.size());
  Matrix rigid(count, order_), elastic = Matrix::Zero(count, unknowns_);
  Index spring = strains;
  for (Index i = 0; i < count; ++i) {
    const LineCondition& condition = all[static_cast<std::size_t>(i)];
    // Slopes are multiplied by the length, to be comparable with values.
    const double scale = condition.on_slope ? length : 1.0;
    const Matrix& rows = condition.on_slope ? slopes : values;
    const auto node = static_cast<Index>(condition.node);
    rigid.row(i) = scale * rows.row(node).head(order_);
    elastic.row(i).head(strains) = scale * rows.row(node).tail(strains);
    if (!condition.is_rigid()) elastic(i, spring++) = -scale * condition.flexibility;
  }
  const Index rank = held_.cols();
  follow_ = Matrix::Zero(order_, unknowns_);
  if (rank == 0) {
    reflect(elastic.transpose());
    return;
  }
  const Matrix moved = product<double>(rigid, held_);
  const Matrix basis = orthonormal_columns<double>(moved, count);
  const Matrix along = basis.leftCols(rank).transpose();
  follow_ = -product<double>(
      held_,
      LuFactors(product<double>(along, moved)).solve_columns(product<double>(along, elastic)));
  reflect(transposed_product<double>(elastic, basis.rightCols(count - rank)));
}

// Decided by counting, not by rank: one held place leaves the rotation about it, two leave nothing.
void LineConditions::choose_rigid(const Line& line, const std::vector<LineCondition>& all) {
  std::vector<std::size_t> held;  // nodes
  bool holds_slope = false;
  for (const LineCondition& condition : all) {
    holds_slope = holds_slope || condition.on_slope;
    if (!condition.on_slope && std::find(held.begin(), held.end(), condition.node) == held.end())
      held.push_back(condition.node);
  }
  if (line.order == 1) {
    const RigidMotions shift = RigidMotions::Ones(1, 1);
    free_ = held.empty() ? shift : RigidMotions(1, 0);
    held_ = held.empty() ? RigidMotions(1, 0) : shift;
    return;
  }
  const double length = line.length.value;
  double about = 0.5 * length;
  for (const LineCondition& condition : all)
    if (!condition.on_slope && condition.node == held.front()) about = condition.x;
  const Vector shift{{1.0, 0.0}}, turn{{-about / length, 1.0 / length}};
  const std::size_t rank = std::min<std::size_t>(held.size() + (holds_slope ? 1 : 0), 2);
  free_.resize(2, static_cast<Index>(2 - rank));
  held_.resize(2, static_cast<Index>(rank));
  if (rank == 0) free_ << shift, turn;
  if (rank == 2) held_ << shift, turn;
  if (rank == 1 && holds_slope) free_ = shift, held_ = turn;
  if (rank == 1 && !holds_slope) free_ = turn, held_ = shift;
}

// Reflections that make the normals upper triangular; the remaining unknowns are their null space.
void LineConditions::reflect(Matrix normals) {
  const Index count = normals.cols();
  reflectors_ = Matrix::Zero(unknowns_, count);
  for (Index i = 0; i < count; ++i) {
    auto below = normals.col(i).tail(unknowns_ - i);
    const double size = below.norm();
    if (!(size > 0.0)) continue;
    Vector direction = below / size;
    direction[0] += direction[0] < 0.0 ? -1.0 : 1.0;
    direction.normalize();
    reflectors_.col(i).tail(unknowns_ - i) = direction;
    normals -= 2.0 * reflectors_.col(i) * (reflectors_.col(i).transpose() * normals).eval();
  }
}

Matrix LineConditions::reduced_rows(const Matrix& rows) const {
  Matrix all = product<double>(rows.leftCols(order_), follow_);
  all.leftCols(unknowns_ - springs_) += rows.rightCols(rows.cols() - order_);
  for (Index i = 0; i < reflectors_.cols(); ++i) {
    const Vector along = all * reflectors_.col(i);
    all.noalias() -= 2.0 * along * reflectors_.col(i).transpose();
  }
  return all.rightCols(reduced());
}

Matrix LineConditions::unknowns_of(const Matrix& v) const {
  Matrix z = Matrix::Zero(unknowns_, v.cols());
  z.bottomRows(reduced()) = v;
  for (Index i = reflectors_.cols(); i-- > 0;) {
    const Eigen::RowVectorXd along = reflectors_.col(i).transpose() * z;
    z.noalias() -= 2.0 * reflectors_.col(i) * along;
  }
  const Index strains = unknowns_ - springs_;
  Matrix y(order_ + strains, v.cols());
  y.topRows(order_) = product<double>(follow_, z);
  y.bottomRows(strains) = z.topRows(strains);
  return y;
}

}  // namespace graze
