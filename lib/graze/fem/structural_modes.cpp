#include "graze/fem/structural_modes.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/fem/detail/judged_modes.hpp"
#include "graze/fem/detail/masses.hpp"
#include "graze/fem/detail/mode_polish.hpp"
#include "graze/fem/detail/shift_invert.hpp"
#include "graze/fem/detail/sparse_cholesky.hpp"

namespace graze {
namespace {

void judge(const StructuralMatrices& structure, const Matrix& vectors, StructuralModes& modes) {
  JudgedModes judged = judged_modes(structure, vectors);
  modes.omega = std::move(judged.omega);
  modes.shapes = std::move(judged.shapes);
  modes.residuals = std::move(judged.residuals);
  modes.square_roundings = std::move(judged.square_roundings);
  modes.rigid = judged.rigid;
}

// Pivots below this share of their diagonal entries show a matrix that is singular within rounding.
constexpr double kSingularPivot = 1e-12;

// Shifts relative to the median of K_ii/M_ii. The first one for a free structure is far above the
// rounding of K for smooth shapes, and far below most frequencies.
constexpr double kRelativeShifts[] = {0.0, -1e-10, -1e-8, -1e-6};

double typical_square(const StructuralMatrices& structure) {
  const Vector k = structure.stiffness.diagonal(), m = structure.mass.diagonal();
  std::vector<double> ratios;
  for (Eigen::Index i = 0; i < k.size(); ++i)
    if (k[i] > 0.0 && m[i] > 0.0) ratios.push_back(k[i] / m[i]);
  if (ratios.empty()) return 1.0;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

// Above this no combination of degrees of freedom without mass is free within rounding, which
// accumulates in the factors of long chains of elements.
constexpr double kSafePivot = 1e-8;

// K - shift M with its factors. Motions that have neither mass nor stiffness, which reduced
// integration may leave (hourglasses), are held by a spring each, at one of their degrees of
// freedom; no force of inertia moves them there.
struct Shifted {
  Shifted(const StructuralMatrices& structure, const Masses& masses)
      : structure_(structure),
        masses_(masses),
        stiffness(structure.stiffness),
        matrix(structure.stiffness + structure.mass),
        factors(matrix) {}

  // Factorises with a shift at which the matrix is safely positive definite.
  void factorise() {
    bool found = factorise_at_some();
    if (!found || factors.smallest_pivot().relative < kSafePivot) masses_.check_others();
    if (!found && masses_.is_singular() && hold_idle()) found = factorise_at_some();
    if (found) return;
    refuse_indefinite(structure_,
                      fmt::format("it has an eigenvalue K phi = L M phi below {:.3g} (rad/s)^2, "
                                  "which shows at the degree of freedom {}",
                                  shift, row_name(structure_, weakest_row())));
  }

  // False where the matrix is not safely positive definite there.
  bool factorise_at(double there) {
    shift = there;
    matrix = stiffness - shift * structure_.mass;
    return factors.factorise(matrix) && factors.smallest_pivot().relative > kSingularPivot;
  }

  // Makes the vectors orthogonal to the idle motions, with K's diagonal as the metric.
  void remove_idle(Matrix& vectors) const {
    if (idle.cols() > 0)
      vectors -= product<double>(product<double>(idle, idle_forces().transpose()), vectors);
  }
  // Removes the components of forces along the idle motions.
  void balance_idle(Matrix& forces) const {
    if (idle.cols() > 0)
      forces -= product<double>(idle_forces(), transposed_product<double>(idle, forces));
  }

  const StructuralMatrices& structure_;
  const Masses& masses_;
  double shift = 0.0;
  SparseMatrix stiffness;  // with the springs
  SparseMatrix matrix;
  SparseCholesky factors;
  Matrix idle{};  // n x their number

 private:
  bool factorise_at_some() {
    const double typical = typical_square(structure_);
    return std::any_of(std::begin(kRelativeShifts), std::end(kRelativeShifts),
                       [&](double relative) { return factorise_at(relative * typical); });
  }

  int weakest_row() const {
    const int row = factors.failed_row();
    return row < 0 ? factors.smallest_pivot().row : row;
  }

  // D Z (Z^T D Z)^-1, D the diagonal of K.
  Matrix idle_forces() const {
    const Matrix weighted = structure_.stiffness.diagonal().asDiagonal() * idle;
    return weighted * Eigen::LLT<Matrix>(transposed_product<double>(idle, weighted))
                          .solve(Matrix::Identity(idle.cols(), idle.cols()));
  }

  // At the last shift, where rigid bodies are held by their mass. False where a soft motion has
  // mass or strain energy.
  bool hold_idle() {
    std::vector<int> rows;
    const int most = structure_.size() - masses_.rank();
    while (!factorise_at(shift)) {
      const int row = weakest_row();
      if (row < 0 || static_cast<int>(rows.size()) == most) return false;
      rows.push_back(row);
      stiffness.coeffRef(row, row) += structure_.stiffness.coeff(row, row);
    }
    Matrix forces = Matrix::Zero(structure_.size(), static_cast<Eigen::Index>(rows.size()));
    for (std::size_t j = 0; j < rows.size(); ++j)
      forces(rows[j], static_cast<Eigen::Index>(j)) = structure_.stiffness.coeff(rows[j], rows[j]);
    idle = factors.solve(forces);
    const auto is_none = [](const SparseMatrix& of, const Vector& z, double limit) {
      const Vector size = z.cwiseAbs();
      return std::abs(z.dot(of * z)) <= limit * size.dot(of.cwiseAbs() * size);
    };
    for (const auto& z : idle.colwise())
      if (!is_none(structure_.stiffness, z, kRigidEnergy) ||
          !is_none(structure_.mass, z, kNullMass))
        return false;
    return true;
  }
};

// Modes of the flexibility that the masses see: the largest eigenvalues of F^T S^-1 F, M = F F^T,
// are those of the lowest modes.
Matrix dense_vectors(const StructuralMatrices& structure, const Masses& masses,
                     const Shifted& shifted) {
  const Matrix factor = masses.factor();
  Matrix loads = Matrix::Zero(structure.size(), factor.cols());
  loads(masses.rows(), Eigen::all) = factor;
  const Matrix displaced = shifted.factors.solve(loads);
  const Matrix seen = factor.transpose() * displaced(masses.rows(), Eigen::all);
  const SymmetricModes modes = symmetric_modes(0.5 * (seen + seen.transpose()));
  return displaced * modes.vectors.rowwise().reverse();
}

void keep_lowest(StructuralModes& modes, int count) {
  modes.omega = modes.omega.head(count).eval();
  modes.residuals = modes.residuals.head(count).eval();
  modes.shapes = modes.shapes.leftCols(count).eval();
  modes.square_roundings = modes.square_roundings.head(count).eval();
  modes.free_motions = modes.rigid;
  modes.rigid = std::min(modes.rigid, count);
}

// One more product by S^-1 M, after which the rows without mass are satisfied, and modes within the
// span of the vectors. False where they are not independent.
bool polish(const StructuralMatrices& structure, const Shifted& shifted, Matrix& vectors) {
  vectors = shifted.factors.solve(Matrix(structure.mass * vectors));
  if (!orthonormalise(structure.mass, vectors)) return false;
  diagonalise(shifted.matrix, vectors);
  shifted.remove_idle(vectors);
  return true;
}

// Where to count: in the widest gap, by ratio, between frequencies from the last requested mode on.
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

// True when all modes were found, as far as that can be checked.
bool are_complete(const StructuralMatrices& structure, Shifted& shifted, int rank, int wanted,
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
    const SparseMatrix matrix = shifted.stiffness - shift * structure.mass;
    modes.counted = factors.negative_eigenvalues(matrix);
    if (!modes.counted) modes.not_counted = "L D L^T without pivoting is not accurate enough";
  }
  modes.counted_below = std::sqrt(shift);
  if (modes.counted) return *modes.counted == below;
  const std::optional<double> other =
      nearest_other(factors, structure.mass, rank, modes.shapes, shifted.shift);
  return other && *other >= low * low;
}

// A free structure has a shift so small that its rigid-body modes outweigh all others by many
// orders; one of the size of the first elastic frequency serves those better.
void adapt_shift(const StructuralMatrices& structure, Shifted& shifted, int rank) {
  const double before = shifted.shift;
  std::optional<Matrix> vectors = shift_invert_vectors(shifted.factors, structure.mass, rank,
                                                       std::min(12, rank - 1), before, 0);
  if (!vectors || !orthonormalise(structure.mass, *vectors)) return;
  StructuralModes first;
  judge(structure, *vectors, first);
  if (first.rigid == first.count()) return;
  const double square = first.omega[first.rigid] * first.omega[first.rigid];
  if (square > -4.0 * before && !shifted.factorise_at(-square)) shifted.factorise_at(before);
}

bool find_sparse(const StructuralMatrices& structure, Shifted& shifted, int rank, int count,
                 StructuralModes& modes) {
  if (shifted.shift < 0.0) adapt_shift(structure, shifted, rank);
  modes.shift = shifted.shift;
  // A few more, so that there is a gap beyond the last one to count in.
  const int sought = std::min(count + 4, rank - 1);
  for (int attempt = 0; attempt < 4; ++attempt) {
    std::optional<Matrix> vectors =
        shift_invert_vectors(shifted.factors, structure.mass, rank,
                             std::min(sought + 4 * attempt, rank - 1), shifted.shift, attempt);
    if (!vectors || !polish(structure, shifted, *vectors)) continue;
    judge(structure, *vectors, modes);
    if (are_complete(structure, shifted, rank, count, modes)) return true;
  }
  return false;
}

// (K - s M)^-1 taken to s = 0 on the complement of rigid-body motions: u = S^-1 (P b - s M u)
// contracts by |s|/(w_1^2 + |s|).
Matrix static_displacements(const StructuralMatrices& structure, const Shifted& shifted,
                            const StructuralModes& modes, const Matrix& loads) {
  const Matrix rigid = modes.shapes.leftCols(modes.rigid);
  const Matrix rigid_load = structure.mass * rigid;
  const auto elastic = [&](Matrix u) {
    u -= product<double>(rigid, transposed_product<double>(rigid_load, u));
    shifted.remove_idle(u);
    return u;
  };
  Matrix balanced = loads - product<double>(rigid_load, transposed_product<double>(rigid, loads));
  shifted.balance_idle(balanced);
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

void add_static_displacements(const StructuralMatrices& structure, const Shifted& shifted,
                              const Matrix& loads, StructuralModes& modes) {
  modes.static_displacements = static_displacements(structure, shifted, modes, loads);
  modes.static_roundings = energy_roundings(structure.stiffness, modes.static_displacements);
}

}  // namespace

std::string mode_limit_text(const StructuralMatrices& structure) {
  const std::size_t rank = structure.rows_with_mass().size();
  const bool is_one = rank == 1;
  const char* verb = is_one ? "is" : "are";
  const char* with_mass = is_one ? " and has mass" : " and have mass";
  return fmt::format("{} degree{} of freedom that {} not held{}", rank, is_one ? "" : "s", verb,
                     static_cast<int>(rank) < structure.size() ? with_mass : "");
}

StructuralModes lowest_modes(const StructuralMatrices& structure, int count, const Matrix& loads) {
  const Masses masses(structure);
  const int rank = masses.rank();
  if (count < 1 || count > rank)
    throw InputError(fmt::format(
        "{}: {} modes are asked for, the structure has {}", structure.stiffness_file, count,
        masses.is_singular() ? fmt::format("{}, the rank of its mass matrix", rank)
                             : mode_limit_text(structure)));
  Shifted shifted(structure, masses);
  shifted.factorise();
  StructuralModes modes;
  modes.massless = structure.size() - rank;
  modes.massless_motions = static_cast<int>(masses.rows().size()) - rank;
  modes.idle = static_cast<int>(shifted.idle.cols());
  modes.shift = shifted.shift;
  modes.is_dense = structure.size() <= kDenseSize ||
                   (!masses.is_singular() && rank <= std::max(kFewMasses, 3 * count - 1));
  if (modes.is_dense) {
    Matrix vectors = dense_vectors(structure, masses, shifted);
    if (!orthonormalise(structure.mass, vectors) || !polish(structure, shifted, vectors))
      throw InputError(
          fmt::format("{}: its modes cannot be told apart from those of a singular "
                      "mass matrix",
                      structure.mass_file));
    judge(structure, vectors, modes);
    modes.counted = rank;
    modes.counted_below = modes.omega[rank - 1];
  } else if (!find_sparse(structure, shifted, rank, count, modes)) {
    throw InputError(fmt::format(
        "{}: its lowest {} modes were not all found{}", structure.stiffness_file, count,
        modes.counted
            ? fmt::format(", {} lie below {:.6g} rad/s", *modes.counted, modes.counted_below)
            : ""));
  }
  // Uses all rigid-body modes, whether they were requested or not.
  if (loads.cols() > 0) add_static_displacements(structure, shifted, loads, modes);
  keep_lowest(modes, count);
  if (const double worst = modes.residuals.maxCoeff(); !(worst <= kLargestResidual))
    throw InputError(fmt::format("{}: a mode has the residual {:.2g}, allowed is {:g}",
                                 structure.stiffness_file, worst, kLargestResidual));
  return modes;
}

}  // namespace graze
