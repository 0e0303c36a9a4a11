#include "graze/flow/held/detail/first_order.hpp"

#include "graze/base/linalg/decompositions.hpp"

namespace graze {

Matrix extended_generator(const FirstOrderSystem& system, const Vector& load, double s) {
  const Eigen::Index n = system.load.size();
  Matrix extended = Matrix::Zero(n + 3, n + 3);
  extended.topLeftCorner(n, n) = system.generator * s;
  extended.block(0, n, n, 1) = system.force * s;
  extended.block(0, n + 2, n, 1) = load * s;
  extended(n, n + 1) = -system.frequency * s;
  extended(n + 1, n) = system.frequency * s;
  return extended;
}

Matrix exponential_change(const Matrix& extended, const Matrix& x) {
  if (!(extended.norm() < 1.0)) return matrix_exponential(extended) * x - x;
  Matrix sum = Matrix::Zero(x.rows(), x.cols()), term = x;
  // By its series; 20! is beyond 1/eps.
  for (int k = 1; k <= 20; ++k) {
    term = extended * term / k;
    sum += term;
  }
  return sum;
}

}  // namespace graze
