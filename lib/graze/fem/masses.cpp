#include "graze/fem/detail/masses.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/base/errors.hpp"
#include "graze/fem/detail/shift_invert.hpp"
#include "graze/fem/detail/sparse_cholesky.hpp"

namespace graze {
namespace {

// Rows and columns `rows`, ascending, of a matrix.
SparseMatrix principal(const SparseMatrix& matrix, const std::vector<int>& rows) {
  std::vector<int> to(static_cast<std::size_t>(matrix.rows()), -1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    to[static_cast<std::size_t>(rows[i])] = static_cast<int>(i);
  const auto size = static_cast<Eigen::Index>(rows.size());
  SparseMatrix part(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    part.startVec(column);
    for (SparseMatrix::InnerIterator entry(matrix, rows[static_cast<std::size_t>(column)]); entry;
         ++entry)
      if (const int row = to[static_cast<std::size_t>(entry.row())]; row >= 0)
        part.insertBack(row, column) = entry.value();
  }
  part.finalize();
  return part;
}

// Masses of finite elements are well conditioned once their diagonal is scaled to 1 (A. J. Wathen,
// IMA J. Numer. Anal. 7 (1987) 449), which Lanczos' iteration sees for the price of some products;
// factors, which a large structure pays for, decide where they are not.
constexpr double kSafeMass = 1e-2;
// Up to as many rows factors cost nothing.
constexpr int kFewRows = 500;

}  // namespace

std::string row_name(const StructuralMatrices& structure, int row) {
  return row < 0 ? "?" : label_text(structure.labels[static_cast<std::size_t>(row)]);
}

Masses::Masses(const StructuralMatrices& structure)
    : structure_(structure),
      rows_(structure.rows_with_mass()),
      part_(rank() < structure.size() ? principal(structure.mass, rows_) : SparseMatrix()),
      matrix_(rank() < structure.size() ? part_ : structure.mass) {}

void Masses::check_definite() const {
  if (rank() > kFewRows && matrix_.diagonal().minCoeff() > 0.0)
    if (const auto smallest = smallest_scaled_mass(matrix_); smallest > kSafeMass) return;
  SparseCholesky factors(matrix_);
  if (factors.factorise(matrix_) && factors.smallest_pivot() > 0.0) return;
  const int row = factors.failed_row();
  throw InputError(fmt::format(
      "{}: the mass matrix is not positive definite, which shows at the degree of freedom {}",
      structure_.mass_file,
      row_name(structure_, row < 0 ? row : rows_[static_cast<std::size_t>(row)])));
}

// What has no mass must have a stiffness that tells how it follows the rest: no displacement of
// such degrees of freedom alone may be free of strain energy, by the measure of rigid-body modes.
void Masses::check_others() const {
  std::vector<int> rows;
  for (int i = 0; i < structure_.size(); ++i)
    if (!std::binary_search(rows_.begin(), rows_.end(), i)) rows.push_back(i);
  if (rows.empty()) return;
  const SparseMatrix stiffness = principal(structure_.stiffness, rows);
  SparseCholesky factors(stiffness);
  Eigen::Index row = 0;
  if (factors.factorise(stiffness)) {
    // Inverse iteration: its second step has all digits of what is softer by many orders.
    Vector softest = Vector::LinSpaced(stiffness.rows(), 1.0, 2.0);
    for (int step = 0; step < 4; ++step) softest = factors.solve(softest).col(0).normalized();
    const Vector size = softest.cwiseAbs();
    const double energy = softest.dot(stiffness * softest);
    if (energy > kRigidEnergy * size.dot(stiffness.cwiseAbs() * size)) return;
    size.maxCoeff(&row);
  } else {
    row = std::max(factors.failed_row(), 0);
  }
  throw InputError(fmt::format(
      "{}: degrees of freedom without mass can move without strain energy while all with mass "
      "rest, which shows at {}: give them mass or stiffness, or hold them (constraints)",
      structure_.stiffness_file, row_name(structure_, rows[static_cast<std::size_t>(row)])));
}

}  // namespace graze
