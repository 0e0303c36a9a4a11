#include "graze/orbit/problem/detail/held_force.hpp"

#include <algorithm>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {

double HeldForce::phase_of_least() const { return wrapped(0.5 * kTurn - std::arg(swing)); }

std::optional<HeldForce> held_force(const System& system, const std::vector<int>& closed,
                                    int stop) {
  const Eigen::Index n = system.modes(), m = static_cast<Eigen::Index>(closed.size());
  const double frequency = system.forcing()->frequency;
  Matrix at_rest = Matrix::Zero(n + m, n + m);
  Vector held = Vector::Zero(n + m);
  if (system.load()) held.head(n) = *system.load();
  at_rest.diagonal().head(n) = system.omega.cwiseAbs2();
  for (Eigen::Index i = 0; i < m; ++i) {
    const Stop& one = system.stops[static_cast<std::size_t>(closed[static_cast<std::size_t>(i)])];
    at_rest.col(n + i).head(n) = one.direction();
    at_rest.row(n + i).head(n) = one.row.transpose();
    held[n + i] = one.gap;
  }
  Eigen::MatrixXcd swinging = at_rest.cast<Complex>();
  swinging.diagonal().head(n).array() -= frequency * frequency;
  swinging.diagonal().head(n) += Complex(0.0, 2.0 * frequency) * system.delta().cast<Complex>();
  ComplexVector driven = ComplexVector::Zero(n + m);
  driven.head(n) = system.forcing()->amplitude.cast<Complex>();
  const Eigen::Index place = n + (std::find(closed.begin(), closed.end(), stop) - closed.begin());
  HeldForce force{LuFactors(at_rest).solve(held)[place], solve(swinging, driven)[place]};
  if (!std::isfinite(force.least())) return {};
  return force;
}

}  // namespace graze
