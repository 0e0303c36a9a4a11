#include "graze/contact/detail/impulse.hpp"

#include <cmath>

#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {

Vector momentum_direction(const Vector& row) { return row / row.squaredNorm(); }

Vector momentum_direction_rate(const Vector& row, const Vector& row_rate) {
  const double norm2 = row.squaredNorm();
  return row_rate / norm2 - row * (2.0 * row.dot(row_rate) / (norm2 * norm2));
}

Vector collocation_direction(const Matrix& phi, int point, double sign) {
  return sign * LuFactors(phi).solve(Vector::Unit(phi.rows(), point));
}

Vector collocation_direction_rate(const Matrix& phi, const Matrix& phi_rate,
                                  const Vector& direction) {
  return -LuFactors(phi).solve(phi_rate * direction);
}

double impact_energy_change(const Vector& row, const Vector& direction, const Vector& before,
                            double restitution) {
  const double v = row.dot(before);
  const double loss = 0.5 * (1.0 - restitution) * (1.0 + restitution) * v * v / row.squaredNorm();
  // Exactly zero for the momentum law: formed as momentum_direction() does, but not kept.
  const auto oblique = direction - row / row.squaredNorm();
  const double jump = (1.0 + restitution) * v;
  return jump * (0.5 * jump * oblique.squaredNorm() - oblique.dot(before)) - loss;
}

double shared_energy_change(const Vector& row, const Vector& direction, double impulse, double v,
                            double v_after, const Vector& mean) {
  // -impulse direction.mean, with row.mean = (v + v_after)/2 known without rounding.
  const Vector oblique = direction - momentum_direction(row);
  return -impulse * (0.5 * (v + v_after) / row.squaredNorm() + oblique.dot(mean));
}

double worst_energy_gain(const Vector& row, const Vector& direction, double restitution) {
  // Only the plane of b and d changes; there J^T J has determinant r^2 and this trace.
  const double k = 1.0 + restitution;
  const double trace = 2.0 - 2.0 * k + k * k * row.squaredNorm() * direction.squaredNorm();
  const double r2 = restitution * restitution;
  return 0.5 * (trace + std::sqrt(std::fmax(trace * trace - 4.0 * r2, 0.0)));
}

}  // namespace graze
