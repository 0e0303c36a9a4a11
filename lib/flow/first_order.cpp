#include "graze/flow/first_order.hpp"

namespace graze {

Matrix extended_generator(const FirstOrderSystem& system, double s) {
  const Eigen::Index n = system.load.size();
  Matrix extended = Matrix::Zero(n + 3, n + 3);
  extended.topLeftCorner(n, n) = system.generator * s;
  extended.block(0, n, n, 1) = system.force * s;
  extended.block(0, n + 2, n, 1) = system.load * s;
  extended(n, n + 1) = -system.frequency * s;
  extended(n + 1, n) = system.frequency * s;
  return extended;
}

}  // namespace graze
