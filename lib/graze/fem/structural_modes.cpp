#include "graze/fem/structural_modes.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/base/linalg/decompositions.hpp"
#include "graze/fem/detail/mode_polish.hpp"
#include "graze/fem/detail/shift_invert.hpp"
#include "graze/fem/detail/sparse_cholesky.hpp"

namespace graze {
namespace {

// Pivots below this share of their diagonal entries are those of a matrix that is singular but for
// rounding.
constexpr double kSingularPivot = 1e-12;

// Shifts of a free structure, relative to the median of K_ii/M_ii: the first is far above the
// rounding of K, as seen by smooth shapes, and far below most frequencies.
constexpr double kRelativeShifts[] = {1e-10, 1e-8, 1e-6};

double typical_square(const StructuralMatrices& structure) {
  const Vector k = structure.stiffness.diagonal(), m = structure.mass.diagonal();
  std::vector<double> ratios;
  for (Eigen::Index i = 0; i < k.size(); ++i)
    if (k[i] > 0.0) ratios.push_back(k[i] / m[i]);
  if (ratios.empty()) return 1.0;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

std::string name_of(const StructuralMatrices& structure, int row) {
  return row < 0 ? "?" : label_text(structure.labels[static_cast<std::size_t>(row)]);
}

// Masses of finite elements are well conditioned once their diagonal is scaled to 1 (A. J. Wathen,
// IMA J. Numer. Anal. 7 (1987) 449), which Lanczos' iteration sees for the price of some products;
// factors, which a large structure pays for, decide where they are not.
constexpr double kSafeMass = 1e-2;

void check_mass(const StructuralMatrices& structure) {
  if (structure.size() > kDenseSize)
    if (const auto smallest = smallest_scaled_mass(structure.mass); smallest > kSafeMass) return;
  SparseCholesky factors(structure.mass);
  if (factors.factorise(structure.mass) && factors.smallest_pivot() > 0.0) return;
  throw InputError(
      fmt::format("{}: the mass matrix is not positive definite, which shows at the degree of "
                  "freedom {}",
                  structure.mass_file, name_of(structure, factors.failed_row())));
}

[[noreturn]] void refuse_indefinite(const StructuralMatrices& structure, const std::string& why) {
  throw InputError(
      fmt::format("{}: the stiffness matrix is indefinite: {}", structure.stiffness_file, why));
}

// K - shift M with its factors.
struct Shifted {
  explicit Shifted(const StructuralMatrices& structure)
      : structure_(structure), matrix(structure.stiffness + structure.mass), factors(matrix) {}

  // With a shift at which the matrix is safely positive definite.
  void factorise() {
    if (factorise_at(0.0)) return;
    const double typical = typical_square(structure_);
    for (const double relative : kRelativeShifts)
      if (factorise_at(-relative * typical)) return;
    refuse_indefinite(structure_,
                      fmt::format("it has an eigenvalue K phi = L M phi below {:.3g} (rad/s)^2, "
                                  "which shows at the degree of freedom {}",
                                  shift, name_of(structure_, factors.failed_row())));
  }

  // False where the matrix is not safely positive definite there.
  bool factorise_at(double there) {
    shift = there;
    matrix = structure_.stiffness - shift * structure_.mass;
    return factors.factorise(matrix) && factors.smallest_pivot() > kSingularPivot;
  }

  const StructuralMatrices& structure_;
  double shift = 0.0;
  SparseMatrix matrix;
  SparseCholesky factors;
};

// The largest eigenvalues of L^-1 M L^-T, S = L L^T, are those of the lowest modes.
Matrix dense_vectors(const StructuralMatrices& structure, const SparseMatrix& shifted) {
  const Eigen::LLT<Matrix> factors{Matrix(shifted)};
  const auto lower = factors.matrixL();
  const Matrix half = lower.solve(Matrix(structure.mass));
  const Matrix inverse = lower.solve(half.transpose());
  const SymmetricModes modes = symmetric_modes(0.5 * (inverse + inverse.transpose()));
  return factors.matrixU().solve(modes.vectors.rowwise().reverse());
}

// Frequencies, the rigid ones among them, and residuals of vectors that are orthonormal in M.
void judge(const StructuralMatrices& structure, Matrix vectors, StructuralModes& modes) {
  const Matrix stiff = structure.stiffness * vectors;
  const auto m = static_cast<std::size_t>(vectors.cols());
  Vector squares(vectors.cols());
  for (Eigen::Index j = 0; j < vectors.cols(); ++j) squares[j] = vectors.col(j).dot(stiff.col(j));
  std::vector<Eigen::Index> order(m);
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return squares[a] < squares[b]; });
  const SparseMatrix absolute_k = structure.stiffness.cwiseAbs();
  const SparseMatrix absolute_m = structure.mass.cwiseAbs();
  modes.omega.resize(vectors.cols());
  modes.residuals.resize(vectors.cols());
  modes.shapes.resize(vectors.rows(), vectors.cols());
  modes.rigid = 0;
  for (std::size_t k = 0; k < m; ++k) {
    const Eigen::Index j = order[k], at = static_cast<Eigen::Index>(k);
    const Vector phi = vectors.col(j), size = phi.cwiseAbs();
    const Vector scale_k = absolute_k * size;
    const double limit = kRigidEnergy * size.dot(scale_k);
    double square = squares[j];
    if (square < -limit)
      refuse_indefinite(
          structure,
          fmt::format("a mode has the square of a frequency {:.3g} (rad/s)^2, {:.2g} of what the "
                      "entries of the matrix make of its shape and beyond their rounding, {:.2g}",
                      square, square / size.dot(scale_k), kRigidEnergy));
    if (square <= limit) {
      square = 0.0;
      ++modes.rigid;
    }
    modes.omega[at] = std::sqrt(square);
    const Vector residual = stiff.col(j) - square * (structure.mass * phi);
    // Nothing acts on a body of its own that no stiffness holds: it has neither residual nor scale.
    const double scale = (scale_k + square * (absolute_m * size)).norm();
    modes.residuals[at] = scale > 0.0 ? residual.norm() / scale : 0.0;
    // The largest displacement is positive, so that the sign is the same in every run.
    Eigen::Index largest = 0;
    size.maxCoeff(&largest);
    modes.shapes.col(at) = phi[largest] < 0.0 ? Vector(-phi) : phi;
  }
}

void keep_lowest(StructuralModes& modes, int count) {
  modes.omega = modes.omega.head(count).eval();
  modes.residuals = modes.residuals.head(count).eval();
  modes.shapes = modes.shapes.leftCols(count).eval();
  modes.rigid = std::min(modes.rigid, count);
}

// Where to count: in the widest gap, by ratio, between frequencies from the last mode wanted on.
int widest_gap(const Vector& omega, int count) {
  int best = count;
  double ratio = 0.0;
  for (int k = count; k < omega.size(); ++k) {
    const double here = omega[k - 1] > 0.0 ? omega[k] / omega[k - 1] : 1e300 * (omega[k] > 0.0);
    if (here > ratio) {
      ratio = here;
      best = k;
    }
  }
  return best;
}

// True where as many modes were found as there are, as far as that can be told.
bool are_complete(const StructuralMatrices& structure, Shifted& shifted, int wanted,
                  StructuralModes& modes) {
  const int below = widest_gap(modes.omega, wanted);
  const double high = modes.omega[below], low = modes.omega[below - 1];
  const double shift = 0.5 * (low * low + high * high);
  SparseCholesky& factors = shifted.factors;
  modes.counted.reset();
  modes.not_counted = "";
  if (factors.operations() > kLargestCount) {
    modes.not_counted = fmt::format("L D L^T without supernodes would take {:.1g} operations",
                                    factors.operations());
  } else {
    const SparseMatrix matrix = structure.stiffness - shift * structure.mass;
    modes.counted = factors.negative_eigenvalues(matrix);
    if (!modes.counted) modes.not_counted = "L D L^T without pivoting is not accurate enough";
  }
  modes.counted_below = std::sqrt(shift);
  if (modes.counted) return *modes.counted == below;
  const std::optional<double> other =
      nearest_other(factors, structure.mass, modes.shapes, shifted.shift);
  return other && *other >= low * low;
}

// A free structure has a shift so small that its rigid-body modes outweigh all others by many
// orders; one of the size of the first elastic frequency serves those better.
void adapt_shift(const StructuralMatrices& structure, Shifted& shifted, int count) {
  const int few = std::min(std::max(count, 12), structure.size() - 1);
  const double before = shifted.shift;
  std::optional<Matrix> vectors =
      shift_invert_vectors(shifted.factors, structure.mass, std::min(few, 12), before, 0);
  if (!vectors || !orthonormalise(structure.mass, *vectors)) return;
  StructuralModes first;
  judge(structure, std::move(*vectors), first);
  if (first.rigid == first.count()) return;
  const double square = first.omega[first.rigid] * first.omega[first.rigid];
  if (square > -4.0 * before && !shifted.factorise_at(-square)) shifted.factorise_at(before);
}

bool find_sparse(const StructuralMatrices& structure, Shifted& shifted, int count,
                 StructuralModes& modes) {
  if (shifted.shift < 0.0) adapt_shift(structure, shifted, count);
  modes.shift = shifted.shift;
  // A few more, so that there is a gap behind the last to count in.
  const int sought = std::min(count + 4, structure.size() - 1);
  for (int attempt = 0; attempt < 4; ++attempt) {
    std::optional<Matrix> vectors = shift_invert_vectors(
        shifted.factors, structure.mass, std::min(sought + 4 * attempt, structure.size() - 1),
        shifted.shift, attempt);
    if (!vectors) continue;
    Matrix polished = shifted.factors.solve(Matrix(structure.mass * *vectors));
    if (!orthonormalise(structure.mass, polished)) continue;
    diagonalise(shifted.matrix, polished);
    judge(structure, std::move(polished), modes);
    if (are_complete(structure, shifted, count, modes)) return true;
  }
  return false;
}

// (K - s M)^-1 taken to s = 0 on what is no rigid-body motion: u = S^-1 (P b - s M u) contracts by
// |s|/(w_1^2 + |s|).
Matrix static_displacements(const StructuralMatrices& structure, const Shifted& shifted,
                            const StructuralModes& modes, const Matrix& loads) {
  const Matrix rigid = modes.shapes.leftCols(modes.rigid);
  const Matrix rigid_load = structure.mass * rigid;
  const auto elastic = [&](const Matrix& u) {
    return Matrix(u - rigid * (rigid_load.transpose() * u));
  };
  const Matrix balanced = loads - rigid_load * (rigid.transpose() * loads);
  Matrix u = elastic(shifted.factors.solve(balanced));
  if (shifted.shift == 0.0) return u;
  for (int k = 0; k < 200; ++k) {
    const Matrix load = balanced - shifted.shift * (structure.mass * u);
    const Matrix next = elastic(shifted.factors.solve(load));
    const double change = (next - u).norm();
    u = next;
    if (change <= 1e-14 * u.norm()) break;
  }
  return u;
}

}  // namespace

StructuralModes lowest_modes(const StructuralMatrices& structure, int count, const Matrix& loads) {
  const int size = structure.size();
  if (count < 1 || count > size)
    throw InputError(fmt::format(
        "{}: {} modes are asked for, the structure has {} degree{} of freedom that {} not held",
        structure.stiffness_file, count, size, size == 1 ? "" : "s", size == 1 ? "is" : "are"));
  check_mass(structure);
  Shifted shifted(structure);
  shifted.factorise();
  StructuralModes modes;
  modes.shift = shifted.shift;
  modes.is_dense = size <= kDenseSize || 3 * count > size;
  if (modes.is_dense) {
    Matrix vectors = dense_vectors(structure, shifted.matrix);
    if (!orthonormalise(structure.mass, vectors))
      throw InputError(
          fmt::format("{}: its modes cannot be told apart from those of a singular "
                      "mass matrix",
                      structure.mass_file));
    diagonalise(shifted.matrix, vectors);
    judge(structure, std::move(vectors), modes);
    modes.counted = size;
    modes.counted_below = modes.omega[size - 1];
  } else if (!find_sparse(structure, shifted, count, modes)) {
    throw InputError(fmt::format(
        "{}: its lowest {} modes were not all found{}", structure.stiffness_file, count,
        modes.counted
            ? fmt::format(", {} lie below {:.6g} rad/s", *modes.counted, modes.counted_below)
            : ""));
  }
  keep_lowest(modes, count);
  if (const double worst = modes.residuals.maxCoeff(); !(worst <= kLargestResidual))
    throw InputError(fmt::format("{}: a mode has the residual {:.2g}, allowed is {:g}",
                                 structure.stiffness_file, worst, kLargestResidual));
  if (loads.cols() > 0) {
    modes.static_displacements = static_displacements(structure, shifted, modes, loads);
  }
  return modes;
}

}  // namespace graze
