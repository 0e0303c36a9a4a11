#include "graze/orbit/problem/detail/saltation.hpp"

#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

Matrix saltation_matrix(const System& system, const Stop& stop, const State& before, double theta) {
  const Eigen::Index n = system.modes();
  const double v = stop.row.dot(before.qdot);
  const double jump = (1.0 + stop.restitution().at(v)) * v, slope = jump_slope(stop, v);
  const State rate_before = vector_field(system, before, theta);
  const State rate_after = vector_field(system, after_impact(stop, before), theta);
  // f+ - J f-: the displacement part is the jump of velocity, -(1 + r) v d. J holds the derivative
  // of the jump by v, 1 + r + v r'.
  Vector defect(2 * n);
  defect.head(n) = -jump * stop.direction();
  defect.tail(n) = rate_after.qdot - rate_before.qdot +
                   slope * stop.row.dot(rate_before.qdot) * stop.direction();
  Matrix s = Matrix::Identity(2 * n, 2 * n);
  s.bottomRightCorner(n, n) -= slope * stop.direction() * stop.row.transpose();
  s.leftCols(n) += defect / v * stop.row.transpose();
  return s;
}

}  // namespace graze
