// Square linear equations. Compiled once: what Eigen makes of them takes seconds of compile time in
// every file that solves one.
#pragma once

#include <Eigen/LU>

#include "graze/base/vector.hpp"

namespace graze {

// The LU factors of a real square matrix A, with row interchanges. Solutions with a singular matrix
// are not finite, or meaningless; see reciprocal_condition.
class LuFactors {
 public:
  explicit LuFactors(const Matrix& matrix);

  Vector solve(const Vector& right) const;             // x of A x = right
  Matrix solve_columns(const Matrix& right) const;     // X of A X = right
  Vector solve_transposed(const Vector& right) const;  // x of A^T x = right
  Matrix inverse() const;
  int determinant_sign() const;     // 1 or -1
  double determinant_size() const;  // |det A|
  // Estimate of 1/(|A| |A^-1|) in the 1-norm.
  double reciprocal_condition() const;

 private:
  Eigen::PartialPivLU<Matrix> factors_;
};

// The LU factors of a complex square matrix.
class ComplexLuFactors {
 public:
  explicit ComplexLuFactors(const Eigen::MatrixXcd& matrix);

  ComplexVector solve(const ComplexVector& right) const;             // x of A x = right
  ComplexVector solve_transposed(const ComplexVector& right) const;  // x of A^T x = right
  double log_modulus() const;                                        // log |det A|

 private:
  Eigen::PartialPivLU<Eigen::MatrixXcd> factors_;
};

ComplexVector solve(const Eigen::MatrixXcd& matrix, const ComplexVector& right);
Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& matrix);

}  // namespace graze

extern template class Eigen::PartialPivLU<Eigen::MatrixXd>;
extern template class Eigen::PartialPivLU<Eigen::MatrixXcd>;
