// The degrees of freedom of a structure with mass, and those that follow them.
#pragma once

#include <string>
#include <vector>

#include "graze/fem/structural_matrices.hpp"

namespace graze {

// The degrees of freedom with mass of a structure, which must outlive it. Elements with reduced
// integration leave the mass matrix semidefinite on them: combinations of them have no mass.
class Masses {
 public:
  // Throws InputError where the mass matrix has a negative eigenvalue.
  explicit Masses(const StructuralMatrices& structure);
  Masses(const Masses&) = delete;
  Masses& operator=(const Masses&) = delete;

  // Throws InputError where the other degrees of freedom, whose rows of the mass are zero, can move
  // without strain energy while those with mass rest: their stiffness then does not determine them.
  void check_others() const;

  // Rank of the mass matrix, which is the number of modes. For a large semidefinite matrix, whose
  // eigenvalues could not be counted, the number of rows.
  int rank() const { return rank_; }
  bool is_singular() const { return is_singular_; }       // on its rows
  const std::vector<int>& rows() const { return rows_; }  // that are not zero, ascending
  // F with M = F F^T on these rows, rows by rank; empty for a large semidefinite matrix.
  Matrix factor() const;

 private:
  bool is_definite() const;
  void find_rank();
  [[noreturn]] void refuse(Eigen::Index row) const;

  const StructuralMatrices& structure_;
  const std::vector<int> rows_;
  const SparseMatrix part_;  // where not all have mass
  const SparseMatrix& matrix_;
  int rank_;
  bool is_singular_ = false;
  Matrix factor_;  // of a semidefinite one
};

// An eigenvalue of D^-1/2 M D^-1/2, D the diagonal of M, below this counts as 0: files with 14
// digits have errors of 5e-14 of each entry, and some 80 entries a row.
inline constexpr double kNullMass = 1e-11;

// The name of a row, for messages; "?" for a negative one.
std::string row_name(const StructuralMatrices& structure, int row);

}  // namespace graze
