#include "graze/base/linalg/detail/linear_equations.hpp"

#include <cmath>

// Only what is used here; instantiating all of the class would add triangular products, too.
template void Eigen::PartialPivLU<Eigen::MatrixXd>::compute();
template double Eigen::PartialPivLU<Eigen::MatrixXd>::determinant() const;
template void Eigen::PartialPivLU<Eigen::MatrixXcd>::compute();

namespace graze {

LuFactors::LuFactors(const Matrix& matrix) : factors_(matrix) {}

Vector LuFactors::solve(const Vector& right) const { return factors_.solve(right); }

Matrix LuFactors::solve_columns(const Matrix& right) const { return factors_.solve(right); }

Vector LuFactors::solve_transposed(const Vector& right) const {
  return factors_.transpose().solve(right);
}

Matrix LuFactors::inverse() const { return factors_.inverse(); }

int LuFactors::determinant_sign() const {
  int sign = static_cast<int>(factors_.permutationP().determinant());
  for (const double pivot : factors_.matrixLU().diagonal())
    if (pivot < 0.0) sign = -sign;
  return sign;
}

double LuFactors::determinant_size() const { return std::abs(factors_.determinant()); }

double LuFactors::reciprocal_condition() const { return factors_.rcond(); }

ComplexLuFactors::ComplexLuFactors(const Eigen::MatrixXcd& matrix) : factors_(matrix) {}

ComplexVector ComplexLuFactors::solve(const ComplexVector& right) const {
  return factors_.solve(right);
}

ComplexVector ComplexLuFactors::solve_transposed(const ComplexVector& right) const {
  return factors_.transpose().solve(right);
}

double ComplexLuFactors::log_modulus() const {
  return factors_.matrixLU().diagonal().array().abs().log().sum();
}

ComplexVector solve(const Eigen::MatrixXcd& matrix, const ComplexVector& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& matrix) { return matrix.partialPivLu().inverse(); }

}  // namespace graze
