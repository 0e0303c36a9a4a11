#include "graze/fem/detail/judged_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

// Makes the first of the largest displacements positive, so that the sign is the same in every run:
// those on both sides of a symmetric structure differ by rounding.
double sign_of(const Vector& phi) {
  const double large = (1.0 - 1e-6) * phi.cwiseAbs().maxCoeff();
  const auto first =
      std::find_if(phi.begin(), phi.end(), [=](double value) { return std::abs(value) >= large; });
  return first != phi.end() && *first < 0.0 ? -1.0 : 1.0;
}

struct JudgedMode {
  Vector shape;
  double energy = 0.0;    // phi^T K phi
  double square = 0.0;    // of the frequency: the energy, 0 of a rigid body
  double residual = 0.0;  // relative
};

class Judge {
 public:
  Judge(const StructuralMatrices& structure, const Matrix& vectors)
      : structure_(structure),
        absolute_k_(structure.stiffness.cwiseAbs()),
        absolute_m_(structure.mass.cwiseAbs()),
        rounding_(kShapeRounding * vectors.cwiseAbs().rowwise().maxCoeff()) {}

  JudgedMode judged(const Vector& phi) const {
    JudgedMode found = as_it_is(phi);
    if (found.square == 0.0 && found.residual <= kLargestResidual) return found;
    // Where a separate body is coupled to others by its mass alone, these rest in its rigid-body
    // mode, and their computed motion is the rounding of other modes. If the shape without that
    // motion has no strain energy, it is itself a mode of the frequency 0.
    const Vector plain = (phi.array().abs() > rounding_.array()).select(phi, 0.0);
    if (plain == phi) return found;
    JudgedMode rigid = as_it_is(plain);
    return rigid.square == 0.0 ? rigid : found;
  }

 private:
  JudgedMode as_it_is(const Vector& phi) const {
    const Vector size = phi.cwiseAbs(), scale_k = absolute_k_ * size;
    const Vector forces = structure_.stiffness * phi;
    const double limit = kRigidEnergy * size.dot(scale_k);
    JudgedMode mode{phi, phi.dot(forces)};
    if (mode.energy < -limit)
      refuse_indefinite(
          structure_,
          fmt::format("a mode has the square of a frequency {:.3g} (rad/s)^2, {:.2g} of what the "
                      "entries of the matrix make of its shape and beyond their rounding, {:.2g}",
                      mode.energy, mode.energy / size.dot(scale_k), kRigidEnergy));
    mode.square = mode.energy <= limit ? 0.0 : mode.energy;
    const Vector residual = forces - mode.square * (structure_.mass * phi);
    // No force acts on a separate body without stiffness: it has neither residual nor scale.
    const double scale = (scale_k + mode.square * (absolute_m_ * size)).norm();
    mode.residual = scale > 0.0 ? residual.norm() / scale : 0.0;
    return mode;
  }

  // Modes are separated by linear combinations of columns, which round each entry by some units in
  // the last place of the largest of its row; as many as kRigidEnergy has.
  static constexpr double kShapeRounding = kRigidEnergy;

  const StructuralMatrices& structure_;
  const SparseMatrix absolute_k_, absolute_m_;
  const Vector rounding_;
};

}  // namespace

void refuse_indefinite(const StructuralMatrices& structure, const std::string& why) {
  throw InputError(
      fmt::format("{}: the stiffness matrix is indefinite: {}", structure.stiffness_file, why));
}

Vector energy_roundings(const SparseMatrix& stiffness, const Matrix& columns) {
  const Matrix squares = columns.cwiseAbs2();
  const SparseMatrix entries = stiffness.cwiseProduct(stiffness);
  const Matrix moved = entries * squares;
  return 0.5 * std::numeric_limits<double>::epsilon() *
         squares.cwiseProduct(moved).colwise().sum().cwiseSqrt().transpose();
}

JudgedModes judged_modes(const StructuralMatrices& structure, const Matrix& vectors) {
  const Judge judge(structure, vectors);
  std::vector<JudgedMode> judged;
  for (Eigen::Index j = 0; j < vectors.cols(); ++j) judged.push_back(judge.judged(vectors.col(j)));
  std::sort(judged.begin(), judged.end(), [](const JudgedMode& a, const JudgedMode& b) {
    return std::tie(a.square, a.energy) < std::tie(b.square, b.energy);
  });
  JudgedModes modes;
  modes.omega.resize(vectors.cols());
  modes.residuals.resize(vectors.cols());
  modes.shapes.resize(vectors.rows(), vectors.cols());
  for (Eigen::Index j = 0; j < vectors.cols(); ++j) {
    const JudgedMode& mode = judged[static_cast<std::size_t>(j)];
    modes.omega[j] = std::sqrt(mode.square);
    modes.residuals[j] = mode.residual;
    modes.shapes.col(j) = sign_of(mode.shape) * mode.shape;
    modes.rigid += mode.square == 0.0;
  }
  modes.square_roundings = energy_roundings(structure.stiffness, modes.shapes);
  return modes;
}

}  // namespace graze
