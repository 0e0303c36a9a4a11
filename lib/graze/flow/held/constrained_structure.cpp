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
                        whole.coupling,
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

}  // namespace

CoupledSystem couple(ConstrainedStructure<double>& held) {
  CoupledSystem coupled;
  if (held.is_free()) {
    coupled = free_system(held.whole);
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
    if (held.reduced.omega.minCoeff() > 0.0 && stiffness.is_invertible()) {
      const Vector balance = stiffness.solve(coupled.load);
      if (balance.norm() <= kLargestAmplification * held.whole.reach) {
        held.rest += held.basis * balance;
        coupled.load.setZero();
      }
    }
  }
  coupled.force = held.whole.forced ? Vector(left * held.whole.amplitude) : Vector(Vector::Zero(m));
  scale_rates(held, coupled);
  return coupled;
}

}  // namespace graze
