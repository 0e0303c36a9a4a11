#include "graze/fem/detail/shift_invert.hpp"

#include <Spectra/SymEigsSolver.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

struct Inverse {
  using Scalar = double;
  const SparseCholesky& factors;
  Eigen::Index size;
  // Projected out of every result: found * (found^T M).
  const Matrix* found = nullptr;
  Matrix weighted{};

  Eigen::Index rows() const { return size; }
  Eigen::Index cols() const { return size; }
  void set_shift(double) {}  // the factors have it
  void perform_op(const double* x, double* y) const {
    factors.solve(x, y);
    if (!found) return;
    Eigen::Map<Vector> result(y, size);
    for (int pass = 0; pass < 2; ++pass) result -= *found * (weighted.transpose() * result).eval();
  }
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

struct ScaledMass {
  using Scalar = double;
  const SparseMatrix& mass;
  Vector roots;  // 1/sqrt(M_ii)

  Eigen::Index rows() const { return mass.rows(); }
  Eigen::Index cols() const { return mass.cols(); }
  void perform_op(const double* x, double* y) const {
    const Vector from = roots.cwiseProduct(Eigen::Map<const Vector>(x, mass.cols()));
    Eigen::Map<Vector> to(y, mass.rows());
    to.noalias() = mass * from;
    to.array() *= roots.array();
  }
};

using Solver = Spectra::SymGEigsShiftSolver<Inverse, MassProduct, Spectra::GEigsMode::ShiftInvert>;

// A start vector that shares no symmetry of the structure.
Vector start_vector(Eigen::Index size, int attempt) {
  Vector start(size);
  double angle = 1.0 + attempt;
  for (Eigen::Index i = 0; i < size; ++i) {
    angle = std::fmod(angle + 2.399963229728653 + 1e-3 * static_cast<double>(i % 97), 6.283185307);
    start[i] = std::sin(angle) + 0.25 * std::cos(3.0 * angle);
  }
  return start;
}

}  // namespace

std::optional<Matrix> shift_invert_vectors(const SparseCholesky& factors, const SparseMatrix& mass,
                                           int rank, int count, double shift, int attempt) {
  const Eigen::Index size = mass.rows();
  Inverse inverse{factors, size};
  MassProduct product{mass};
  const Eigen::Index kept =
      std::min<Eigen::Index>(rank, std::max(2 * count + 1, count + 20) + 20 * attempt);
  Solver solver(inverse, product, count, kept, shift);
  solver.init(start_vector(size, attempt).data());
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) return {};
  return solver.eigenvectors();
}

std::optional<double> nearest_other(const SparseCholesky& factors, const SparseMatrix& mass,
                                    int rank, const Matrix& found, double shift) {
  const Eigen::Index size = mass.rows(), others = rank - found.cols();
  if (others < 2) return {};
  Inverse inverse{factors, size, &found, mass * found};
  MassProduct product{mass};
  Solver solver(inverse, product, 1, std::min<Eigen::Index>(others, 20), shift);
  Vector start = start_vector(size, 7);
  start -= found * (inverse.weighted.transpose() * start).eval();
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-6, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) return {};
  return solver.eigenvalues()[0];
}

std::optional<double> smallest_scaled_mass(const SparseMatrix& mass) {
  ScaledMass scaled{mass, mass.diagonal().cwiseSqrt().cwiseInverse()};
  Spectra::SymEigsSolver<ScaledMass> solver(scaled, 1, std::min<Eigen::Index>(mass.rows(), 30));
  solver.init(start_vector(mass.rows(), 3).data());
  solver.compute(Spectra::SortRule::SmallestAlge, 100, 1e-3);
  if (solver.info() != Spectra::CompInfo::Successful) return {};
  return solver.eigenvalues()[0];
}

}  // namespace graze
