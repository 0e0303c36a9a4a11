#include "graze/orbit/problem/detail/saltation.hpp"

#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

SaltationFactors saltation_factors(const System& system, const Stop& stop, const State& before,
                                   double theta) {
  const Eigen::Index n = system.modes();
  const double v = stop.row.dot(before.qdot);
  const double jump = stop.restitution().jump(v), slope = stop.restitution().jump_slope(v);
  const State rate_before = vector_field(system, before, theta);
  const State rate_after = vector_field(system, after_impact(stop, before), theta);
  SaltationFactors factors{Matrix::Zero(2 * n, 2), Matrix::Zero(2 * n, 2)};
  // f+ - J f-: the displacement part is the jump of velocity, -(1 + r) v d. J holds the derivative
  // of the jump by v, 1 + r + v r'.
  factors.from.col(0).head(n) = -jump * stop.direction();
  factors.from.col(0).tail(n) = rate_after.qdot - rate_before.qdot +
                                slope * stop.row.dot(rate_before.qdot) * stop.direction();
  factors.from.col(0) /= v;
  factors.to.col(0).head(n) = stop.row;
  factors.from.col(1).tail(n) = -slope * stop.direction();
  factors.to.col(1).tail(n) = stop.row;
  return factors;
}

Matrix saltation_matrix(const System& system, const Stop& stop, const State& before, double theta) {
  const Eigen::Index n = system.modes();
  const auto [from, to] = saltation_factors(system, stop, before, theta);
  Matrix s = Matrix::Identity(2 * n, 2 * n);
  s.bottomRightCorner(n, n) += from.col(1).tail(n) * stop.row.transpose();
  s.leftCols(n) += from.col(0) * stop.row.transpose();
  return s;
}

}  // namespace graze
