#include "graze/flow/held/detail/constrained_structure.hpp"

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/held/detail/constrained_structure_impl.hpp"

namespace graze {

template struct ConstrainedStructure<double>;

bool proportional_damping(const System& system) {
  return constrained_structure_detail::proportional_damping(linear_system<double>(system))
      .has_value();
}

namespace {

// Of a structure that no stop holds, in its natural modes.
CoupledSystem free_system(const LinearSystem<double>& whole) {
  const Eigen::Index n = whole.omega.size();
  CoupledSystem coupled{whole.omega.cwiseAbs2().asDiagonal(),
                        whole.coupling.size() > 0 ? whole.coupling : Matrix(Matrix::Zero(n, n)),
                        Vector::Zero(n),
                        Vector::Zero(n),
                        0.0,
                        {}};
  coupled.damping.diagonal() += 2.0 * whole.delta;
  if (whole.load.size() > 0) coupled.load = whole.load;
  if (whole.forced) coupled.force = whole.amplitude;
  return coupled;
}

void scale_rates(const ConstrainedStructure<double>& held, CoupledSystem& coupled) {
  coupled.frequency = held.whole.forced ? held.whole.frequency : 0.0;
  const double slowest = std::max(held.whole.frequency, 1e-3 * held.reduced.omega.maxCoeff());
  coupled.scale = held.reduced.omega.cwiseMax(slowest > 0.0 ? slowest : 1.0);
}

// The matrix with rows and columns of zeros behind its own.
Matrix padded(const Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  Matrix all = Matrix::Zero(rows, columns);
  all.topLeftCorner(matrix.rows(), matrix.cols()) = matrix;
  return all;
}

// A coordinate z = unit cos(k theta) for each harmonic, of the size of what it moves: it presses as
// cosine z/unit - sine z'/(unit k W).
// `inverse`: the left one of the basis, which may be the basis itself.
void add_harmonics(ConstrainedStructure<double>& held, const Matrix& inverse,
                   CoupledSystem& coupled) {
  if (held.whole.harmonics.empty()) return;
  const Matrix left = inverse;  // the basis is widened here
  const auto count = static_cast<Eigen::Index>(held.whole.harmonics.size());
  const Eigen::Index n = held.whole.omega.size(), m = held.size(), all = m + count;
  coupled.stiffness = padded(coupled.stiffness, all, all);
  coupled.damping = padded(coupled.damping, all, all);
  coupled.load = padded(coupled.load, all, 1);
  coupled.force = padded(coupled.force, all, 1);
  held.basis = padded(held.basis, n, all);
  if (held.left.size() > 0) held.left = padded(held.left, all, n);
  held.reduced.omega = padded(held.reduced.omega, all, 1);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Harmonic& one = held.whole.harmonics[static_cast<std::size_t>(k)];
    const double frequency = one.timed ? 0.0 : one.order * held.whole.frequency;
    const double least = one.timed ? 1.0 : frequency;
    const Vector stiffness = held.whole.omega.cwiseAbs2().cwiseMax(least * least);
    const double moved =
        one.cosine.cwiseQuotient(stiffness).norm() + one.sine.cwiseQuotient(stiffness).norm();
    const double unit = moved > 0.0 ? moved : 1.0;
    held.units.push_back(unit);
    held.reduced.omega[m + k] = frequency;
    coupled.stiffness.col(m + k).head(m) = -left * one.cosine / unit;
    if (!one.timed) coupled.damping.col(m + k).head(m) = left * one.sine / (unit * frequency);
    coupled.stiffness(m + k, m + k) = frequency * frequency;
  }
}

// Widens the structure by the coordinate |e| s of what belts drag along.
void add_drift(ConstrainedStructure<double>& held, const Matrix& left, CoupledSystem& coupled) {
  if (held.drift.size() == 0) return;
  const Eigen::Index n = held.rows.rows(), m = held.size(), all = m + 1;
  const Vector along = held.drift.normalized();
  const Vector slowed = 2.0 * held.whole.delta.cwiseProduct(along);
  coupled.stiffness = padded(coupled.stiffness, all, all);
  coupled.damping = padded(coupled.damping, all, all);
  coupled.load = padded(coupled.load, all, 1);
  coupled.force = padded(coupled.force, all, 1);
  coupled.stiffness.col(m).head(m) = left * held.whole.omega.cwiseAbs2().cwiseProduct(along);
  coupled.damping.col(m).head(m) =
      left *
      (held.whole.coupling.size() > 0 ? Vector(slowed + held.whole.coupling * along) : slowed);
  held.basis = padded(held.basis, n, all);
  held.basis.col(m) = along;
  held.reduced.omega = padded(held.reduced.omega, all, 1);
  if (held.left.size() > 0) held.left = padded(held.left, all, n);
}

}  // namespace

CoupledSystem couple(ConstrainedStructure<double>& held) {
  CoupledSystem coupled;
  if (held.constrained.empty()) {
    coupled = free_system(held.whole);
    add_harmonics(held, held.basis, coupled);
    scale_rates(held, coupled);
    return coupled;
  }
  const Eigen::Index n = held.rows.rows(), m = held.size();
  // Left inverse of the basis that is orthogonal to the directions: Z^T U = I, Z^T D = 0.
  Matrix whole(n, n);
  whole << held.basis, held.directions;
  const Matrix left = LuFactors(whole).inverse().topRows(m);
  coupled.damping = left * (2.0 * held.whole.delta).asDiagonal() * held.basis;
  if (held.whole.coupling.size() > 0) coupled.damping += left * held.whole.coupling * held.basis;
  if (held.is_normal) {
    coupled.stiffness = held.reduced.omega.cwiseAbs2().asDiagonal();
    coupled.load = held.balanced_load();
  } else {
    held.left = left;
    // Formed from w U, so that the rounding of stiff directions does not reach soft and free ones.
    coupled.stiffness = left * held.whole.omega.asDiagonal() * held.stretched;
    coupled.load = -left * held.whole.omega.cwiseAbs2().cwiseProduct(held.rest);
    if (held.whole.load.size() > 0) coupled.load += left * held.whole.load;
    const PivotedLu<double> stiffness(coupled.stiffness);
    if (m > 0 && held.reduced.omega.minCoeff() > 0.0 && stiffness.is_invertible()) {
      const Vector balance = stiffness.solve(coupled.load);
      if (balance.norm() <= kLargestAmplification * held.whole.reach) {
        held.rest += held.basis * balance;
        coupled.load.setZero();
      }
    }
  }
  coupled.force = held.whole.forced ? Vector(left * held.whole.amplitude) : Vector(Vector::Zero(m));
  add_drift(held, left, coupled);
  add_harmonics(held, padded(left, held.size(), n), coupled);
  scale_rates(held, coupled);
  return coupled;
}

}  // namespace graze
