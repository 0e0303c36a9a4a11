// What of a structure has mass, and what follows it.
#pragma once

#include <string>
#include <vector>

#include "graze/fem/structural_matrices.hpp"

namespace graze {

// The degrees of freedom with mass of a structure, which must outlive it.
class Masses {
 public:
  explicit Masses(const StructuralMatrices& structure);
  Masses(const Masses&) = delete;
  Masses& operator=(const Masses&) = delete;

  // Throws InputError where the mass matrix is not positive definite on them.
  void check_definite() const;
  // Throws InputError where the others, which have no mass, can move without strain energy while
  // these rest: their stiffness then does not tell how they follow.
  void check_others() const;

  int rank() const { return static_cast<int>(rows_.size()); }
  const std::vector<int>& rows() const { return rows_; }  // ascending
  const SparseMatrix& matrix() const { return matrix_; }  // of these rows

 private:
  const StructuralMatrices& structure_;
  const std::vector<int> rows_;
  const SparseMatrix part_;  // where not all have mass
  const SparseMatrix& matrix_;
};

// The name of a row, for messages; "?" of a negative one.
std::string row_name(const StructuralMatrices& structure, int row);

}  // namespace graze
