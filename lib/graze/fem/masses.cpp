#include "graze/fem/detail/masses.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "graze/base/errors.hpp"
#include "graze/base/linalg/decompositions.hpp"
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
// IMA J. Numer. Anal. 7 (1987) 449), which Lanczos' iteration shows for the price of some products;
// factors, which are expensive for a large structure, decide where they are not.
constexpr double kSafeMass = 1e-2;
// Up to this number of rows factors and eigenvalues cost nothing.
constexpr int kFewRows = 500;
// The shift at which eigenvalues of a semidefinite mass are counted: well above 0, so that L D L^T
// is accurate, and below the smallest nonzero one of elements, 2.8e-3 for CalculiX's ten-node
// tetrahedra.
constexpr double kCountedMass = 1e-5;

}  // namespace

std::string row_name(const StructuralMatrices& structure, int row) {
  return row < 0 ? "?" : label_text(structure.labels[static_cast<std::size_t>(row)]);
}

Masses::Masses(const StructuralMatrices& structure)
    : structure_(structure),
      rows_(structure.rows_with_mass()),
      part_(static_cast<int>(rows_.size()) < structure.size() ? principal(structure.mass, rows_)
                                                              : SparseMatrix()),
      matrix_(part_.size() > 0 ? part_ : structure.mass),
      rank_(static_cast<int>(rows_.size())) {
  if (rows_.empty() || is_definite()) return;
  is_singular_ = true;
  find_rank();
}

bool Masses::is_definite() const {
  if (rank() > kFewRows && matrix_.diagonal().minCoeff() > 0.0)
    if (const auto smallest = smallest_scaled_mass(matrix_); smallest > kSafeMass) return true;
  SparseCholesky factors(matrix_);
  return factors.factorise(matrix_) && factors.smallest_pivot().relative > kNullMass;
}

void Masses::find_rank() {
  const Vector diagonal = matrix_.diagonal();
  Eigen::Index row = 0;
  if (!(diagonal.minCoeff(&row) > 0.0)) refuse(row);
  if (rank_ > kFewRows) {
    const SparseMatrix scale(diagonal.asDiagonal());
    SparseCholesky factors(matrix_);
    const SparseMatrix raised = matrix_ + kNullMass * scale;
    if (!factors.factorise(raised)) refuse(factors.failed_row());
    if (const auto below = factors.negative_eigenvalues(matrix_ - kCountedMass * scale))
      rank_ -= *below;
    return;
  }
  const Vector roots = diagonal.cwiseSqrt();
  const Matrix scaled =
      roots.cwiseInverse().asDiagonal() * Matrix(matrix_) * roots.cwiseInverse().asDiagonal();
  const SymmetricModes modes = symmetric_modes(scaled);
  if (modes.values[0] < -kNullMass) {
    modes.vectors.col(0).cwiseAbs().maxCoeff(&row);
    refuse(row);
  }
  rank_ = static_cast<int>((modes.values.array() > kNullMass).count());
  const Vector sizes = modes.values.tail(rank_).cwiseSqrt();
  factor_ = roots.asDiagonal() * modes.vectors.rightCols(rank_) * sizes.asDiagonal();
}

Matrix Masses::factor() const {
  return is_singular_ ? factor_ : Matrix(Eigen::LLT<Matrix>(Matrix(matrix_)).matrixL());
}

void Masses::refuse(Eigen::Index row) const {
  throw InputError(
      fmt::format("{}: the mass matrix is not positive definite, nor semidefinite, which shows at "
                  "the degree of "
                  "freedom {}",
                  structure_.mass_file,
                  row_name(structure_, row < 0 ? -1 : rows_[static_cast<std::size_t>(row)])));
}

// Degrees of freedom without mass must have a stiffness that determines how they follow the rest:
// no displacement of these alone may be free of strain energy, by the measure of rigid-body modes.
void Masses::check_others() const {
  std::vector<int> rows;
  for (int i = 0; i < structure_.size(); ++i)
    if (!std::binary_search(rows_.begin(), rows_.end(), i)) rows.push_back(i);
  if (rows.empty()) return;
  const SparseMatrix stiffness = principal(structure_.stiffness, rows);
  SparseCholesky factors(stiffness);
  Eigen::Index row = 0;
  if (factors.factorise(stiffness)) {
    // Inverse iteration: its second step has all digits of a vector that is softer by many orders.
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
