#include "graze/base/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

namespace graze {

namespace {

// Backward error of eigenvectors in units of n eps |A|; a few come up.
constexpr double kRoundingsOfModes = 64.0;

}  // namespace

double condition_number(const Matrix& matrix) {
  const Vector sigma = Eigen::JacobiSVD<Matrix>(matrix).singularValues();
  const double smallest = sigma[sigma.size() - 1];
  return smallest > 0.0 ? sigma[0] / smallest : std::numeric_limits<double>::infinity();
}

void sort_eigenvalues(std::vector<Eigenvalue>& list) {
  std::stable_sort(list.begin(), list.end(), [](const Eigenvalue& a, const Eigenvalue& b) {
    const double ma = std::abs(a.value), mb = std::abs(b.value);
    // A conjugate pair has one modulus up to rounding of hypot; Eigen returns it bit-identical.
    if (ma != mb) return ma > mb;
    return a.value.imag() < b.value.imag();
  });
}

std::vector<Eigenvalue> eigenvalues(const Matrix& matrix) {
  const Eigen::EigenSolver<Matrix> solver(matrix, true);
  if (solver.info() != Eigen::Success) return {};
  const Eigen::MatrixXcd right = solver.eigenvectors();
  const Eigen::MatrixXcd left = right.partialPivLu().inverse();
  const double unit =
      std::numeric_limits<double>::epsilon() * static_cast<double>(matrix.rows()) * matrix.norm();
  const double n = static_cast<double>(matrix.rows());
  const double elsner = std::pow(matrix.norm() + unit, 1.0 - 1.0 / n) * std::pow(unit, 1.0 / n);
  std::vector<Eigenvalue> list;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const double first_order = unit * right.col(i).norm() * left.row(i).norm();
    list.push_back({solver.eigenvalues()[i], first_order < elsner ? first_order : elsner});
  }
  sort_eigenvalues(list);
  return list;
}

ComplexModes complex_modes(const Matrix& matrix) {
  const Eigen::EigenSolver<Matrix> solver(matrix, true);
  ComplexModes modes;
  modes.condition = std::numeric_limits<double>::infinity();
  if (solver.info() != Eigen::Success) return modes;
  modes.values = solver.eigenvalues();
  modes.vectors = solver.eigenvectors();
  modes.inverse = modes.vectors.partialPivLu().inverse();
  const double condition = modes.vectors.norm() * modes.inverse.norm();
  // Of a pair that coincides to the last bit the solver returns vectors that are none.
  const double residual =
      (matrix.cast<Complex>() * modes.vectors - modes.vectors * modes.values.asDiagonal()).norm();
  const double rounding = kRoundingsOfModes * static_cast<double>(matrix.rows()) *
                          std::numeric_limits<double>::epsilon() * matrix.norm() *
                          modes.vectors.norm();
  if (std::isfinite(condition) && residual <= rounding) modes.condition = condition;
  return modes;
}

double norm_growth_rate(const Matrix& matrix) {
  if (matrix.rows() == 0) return 0.0;
  const Matrix symmetric = 0.5 * (matrix + matrix.transpose());
  return Eigen::SelfAdjointEigenSolver<Matrix>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

Matrix matrix_exponential(const Matrix& matrix) {
  // A structure held in all its directions has none left: the exponential of nothing is nothing.
  if (matrix.rows() == 0) return matrix;
  return matrix.exp();
}

Vector null_vector(const Matrix& matrix) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(matrix.transpose());
  const Matrix q = qr.householderQ();
  return q.col(q.cols() - 1);
}

NullSpaces null_spaces(const Matrix& matrix, int dimension) {
  const Eigen::JacobiSVD<Matrix, Eigen::FullPivHouseholderQRPreconditioner> svd(
      matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixV().rightCols(dimension), svd.matrixU().rightCols(dimension - 1)};
}

}  // namespace graze
