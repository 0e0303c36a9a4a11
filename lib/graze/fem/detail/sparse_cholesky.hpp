// The Cholesky factors of a sparse symmetric matrix (CHOLMOD: supernodal, nested dissection by
// METIS where it fills less than minimum degree), and the signs of its eigenvalues. For systems of
// one pattern the order is found once.
#pragma once

#include <memory>
#include <optional>

#include "graze/fem/labelled_matrix.hpp"

namespace graze {

class SparseCholesky {
 public:
  // Finds the order for matrices with this pattern.
  explicit SparseCholesky(const SparseMatrix& pattern);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  // False where the matrix is not positive definite; `failed_row` is then the row of the pivot that
  // shows this. Throws std::bad_alloc where the memory does not suffice.
  bool factorise(const SparseMatrix& matrix);
  int failed_row() const;
  // Smallest pivot relative to the diagonal entry it came from, about the unit roundoff where the
  // matrix is singular, and its row.
  struct Pivot {
    double relative;
    int row;
  };
  Pivot smallest_pivot() const;
  // Solves with the present factors.
  Matrix solve(const Matrix& right) const;
  void solve(const double* right, double* result) const;

  // Floating-point operations and entries of the factors.
  double operations() const;
  double entries() const;

  // The number of negative eigenvalues of the matrix, by the signs of D in L D L^T without
  // pivoting. Returns nullopt when a pivot vanishes or when the factors do not solve the system to
  // `kInertiaResidual`, relative: then they are not those of a matrix near this one.
  std::optional<int> negative_eigenvalues(const SparseMatrix& matrix);
  static constexpr double kInertiaResidual = 1e-9;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace graze
