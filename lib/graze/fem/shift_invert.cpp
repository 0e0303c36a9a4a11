#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cmath>

#include "graze/fem/detail/shift_invert.hpp"

namespace graze {
namespace {

struct Inverse {
  using Scalar = double;
  const SparseCholesky& factors;
  Eigen::Index size;

  Eigen::Index rows() const { return size; }
  Eigen::Index cols() const { return size; }
  void set_shift(double) {}  // the factors have it
  void perform_op(const double* x, double* y) const { factors.solve(x, y); }
};

struct MassProduct {
  using Scalar = double;
  const SparseMatrix& mass;

  Eigen::Index rows() const { return mass.rows(); }
  Eigen::Index cols() const { return mass.cols(); }
  void perform_op(const double* x, double* y) const {
    const Eigen::Map<const Vector> from(x, mass.cols());
    Eigen::Map<Vector>(y, mass.rows()).noalias() = mass * from;
  }
};

}  // namespace

std::optional<Matrix> shift_invert_vectors(const SparseCholesky& factors, const SparseMatrix& mass,
                                           int count, double shift, int attempt) {
  const Eigen::Index size = mass.rows();
  Inverse inverse{factors, size};
  MassProduct product{mass};
  const Eigen::Index kept =
      std::min<Eigen::Index>(size, std::max(2 * count + 1, count + 20) + 20 * attempt);
  Spectra::SymGEigsShiftSolver<Inverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, product, count, kept, shift);
  // A start that no symmetry of the structure shares.
  Vector start(size);
  double angle = 1.0 + attempt;
  for (Eigen::Index i = 0; i < size; ++i) {
    angle = std::fmod(angle + 2.399963229728653 + 1e-3 * static_cast<double>(i % 97), 6.283185307);
    start[i] = std::sin(angle) + 0.25 * std::cos(3.0 * angle);
  }
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) return {};
  return solver.eigenvectors();
}

}  // namespace graze
