#include "graze/fem/modal_damping.hpp"

#include <fmt/format.h>

#include <cmath>

#include "graze/base/errors.hpp"
#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/linalg/detail/products.hpp"

namespace graze {
namespace {

double inner(const SparseMatrix& a, const SparseMatrix& b) { return a.cwiseProduct(b).sum(); }

// The combination a M + b K nearest to C, scaled so that neither outweighs the other.
void fit_proportional(const StructuralMatrices& structure, double proportional,
                      ModalDamping& damping) {
  const SparseMatrix& c = *structure.damping;
  const double size_m = structure.mass.norm(), size_k = structure.stiffness.norm();
  const double mm = 1.0, kk = size_k > 0.0 ? 1.0 : 0.0;
  const double mk =
      kk * inner(structure.mass, structure.stiffness) / (size_m * (kk ? size_k : 1.0));
  const double mc = inner(structure.mass, c) / size_m;
  const double kc = kk ? inner(structure.stiffness, c) / size_k : 0.0;
  const double determinant = mm * kk - mk * mk;
  const bool independent = determinant > 1e-14;
  damping.mass = (independent ? (mc * kk - kc * mk) / determinant : mc) / size_m;
  damping.stiffness = independent ? (kc * mm - mc * mk) / determinant / size_k : 0.0;
  const SparseMatrix rest =
      c - damping.mass * structure.mass - damping.stiffness * structure.stiffness;
  damping.is_proportional = rest.norm() <= proportional * c.norm();
}

}  // namespace

ModalDamping modal_damping(const StructuralMatrices& structure, const StructuralModes& modes,
                           double proportional) {
  ModalDamping damping;
  fit_proportional(structure, proportional, damping);
  Matrix projected = transposed_product<double>(modes.shapes, *structure.damping * modes.shapes);
  damping.delta = 0.5 * projected.diagonal();
  if (damping.is_proportional)
    damping.delta =
        0.5 * (damping.mass + damping.stiffness * modes.omega.array().square()).matrix();
  const double largest = damping.delta.cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < damping.delta.size(); ++j) {
    if (damping.delta[j] < -1e-12 * largest)
      throw InputError(
          fmt::format("{}: the damping matrix gives energy to mode {}, its decay rate "
                      "is {:.4g} 1/s and must be at least 0",
                      structure.damping_file, j + 1, damping.delta[j]));
    damping.delta[j] = std::max(damping.delta[j], 0.0);
  }
  if (damping.is_proportional) return damping;
  const double size = projected.norm();
  const double lowest = symmetric_modes(0.5 * (projected + projected.transpose())).values[0];
  if (lowest < -kProportional * size)
    throw InputError(fmt::format(
        "{}: the damping matrix gives energy to a motion, its lowest eigenvalue in the modes is "
        "{:.4g} 1/s and must be at least 0",
        structure.damping_file, lowest));
  projected.diagonal().setZero();
  if (projected.norm() > proportional * size) damping.coupling = std::move(projected);
  return damping;
}

}  // namespace graze
