#include "graze/fem/detail/mode_polish.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Jacobi>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/products.hpp"

namespace graze {

bool orthonormalise(const SparseMatrix& mass, Matrix& vectors) {
  // Two passes, as the first one leaves rounding multiplied by the condition of the columns.
  for (int pass = 0; pass < 2; ++pass) {
    const Matrix gram = transposed_product<double>(vectors, mass * vectors);
    const Eigen::LLT<Matrix> factors(gram);
    if (factors.info() != Eigen::Success) return false;
    factors.matrixU().solveInPlace<Eigen::OnTheRight>(vectors);
  }
  return true;
}

void diagonalise(const SparseMatrix& matrix, Matrix& vectors) {
  Matrix a = transposed_product<double>(vectors, matrix * vectors);
  a = (0.5 * (a + a.transpose())).eval();
  const Eigen::Index n = a.rows();
  for (int sweep = 0; sweep < 30; ++sweep) {
    bool rotated = false;
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = p + 1; q < n; ++q) {
        const double scale = std::sqrt(std::abs(a(p, p) * a(q, q)));
        if (std::abs(a(p, q)) <= std::numeric_limits<double>::epsilon() * scale) continue;
        Eigen::JacobiRotation<double> rotation;
        if (!rotation.makeJacobi(a, p, q)) continue;
        a.applyOnTheLeft(p, q, rotation.adjoint());
        a.applyOnTheRight(p, q, rotation);
        vectors.applyOnTheRight(p, q, rotation);
        rotated = true;
      }
    }
    if (!rotated) return;
  }
}

}  // namespace graze
