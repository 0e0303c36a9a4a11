#include <cmath>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/flow/held/detail/first_order.hpp"
#include "graze/flow/variation/detail/sprung_deviation.hpp"

namespace graze {
namespace {

using Eigen::Index;

// The exponential of twice 2 n + 3 states grows with the cube of n, integration with n: with more
// modes integration is faster.
constexpr int kMostModes = 16;

// A number of a linear spring and its rate.
struct SpringRates {
  const Stop& stop;
  const Stop& rate;
  double depth;  // at the start, m

  double stiffness() const { return stop.force().stiffness; }
  double damping() const { return dashpot_of(stop.force()); }
  double stiffness_rate() const { return rate.is_compliant() ? rate.force().stiffness : 0.0; }
  double damping_rate() const { return rate.is_compliant() ? coefficient_rate() : 0.0; }
  // Derivative of the depth by the parameter at fixed displacements q.
  double depth_rate(const Vector& q) const { return rate.row.dot(q) - rate.gap; }

 private:
  double coefficient_rate() const {
    return stop.force().damping == ContactDamping::kNone ? 0.0 : rate.force().coefficient;
  }
};

// Equations of the displacements z from the start and of the velocities, z'' = load + force cos
// theta - D z' - K z, and their derivatives by the parameter.
struct Equations {
  Matrix stiffness, damping;
  Vector load, force;
  double frequency;

  // On (w z, z', cos theta, sin theta, 1); `own`: 1 of the equations, 0 of their rates.
  Matrix generator(const Vector& scale, double own) const {
    const Index n = scale.size();
    Matrix a = Matrix::Zero(2 * n + 3, 2 * n + 3);
    a.block(0, n, n, n) = own * Matrix(scale.asDiagonal());
    a.block(n, 0, n, n) = -stiffness * scale.cwiseInverse().asDiagonal();
    a.block(n, n, n, n) = -damping;
    a.block(n, 2 * n, n, 1) = force;
    a.block(n, 2 * n + 2, n, 1) = load;
    a(2 * n, 2 * n + 1) = -frequency;
    a(2 * n + 1, 2 * n) = frequency;
    return a;
  }
};

Vector or_zero(const Vector* vector, Index n) { return vector ? *vector : Vector(Vector::Zero(n)); }

Equations equations_of(const System& system, const std::vector<SpringRates>& springs,
                       const Vector& q) {
  const Vector stiffness = system.omega.cwiseAbs2();
  Equations all{stiffness.asDiagonal(), system.damping(),
                or_zero(system.load(), q.size()) - stiffness.cwiseProduct(q),
                system.forcing()->amplitude, system.forcing()->frequency};
  for (const SpringRates& spring : springs) {
    const Vector& row = spring.stop.row;
    all.stiffness += spring.stiffness() * row * row.transpose();
    all.damping += spring.damping() * row * row.transpose();
    all.load -= spring.stiffness() * spring.depth * row;
  }
  return all;
}

Equations rates_of(const System& system, const System& tangent,
                   const std::vector<SpringRates>& springs, const Vector& q) {
  const Vector stiffness = 2.0 * system.omega.cwiseProduct(tangent.omega);
  Equations all{stiffness.asDiagonal(), tangent.damping(),
                or_zero(tangent.load(), q.size()) - stiffness.cwiseProduct(q),
                tangent.forcing()->amplitude, tangent.forcing()->frequency};
  for (const SpringRates& spring : springs) {
    const Vector &row = spring.stop.row, &row_rate = spring.rate.row;
    const Matrix turned = row * row_rate.transpose() + row_rate * row.transpose();
    all.stiffness += spring.stiffness_rate() * row * row.transpose() + spring.stiffness() * turned;
    all.damping += spring.damping_rate() * row * row.transpose() + spring.damping() * turned;
    all.load -= spring.stiffness_rate() * spring.depth * row +
                spring.stiffness() * (spring.depth_rate(q) * row + spring.depth * row_rate);
  }
  return all;
}

}  // namespace

// Instants are compared at equal phases, so the clock runs in forcing phase: E s with s = phase/W.
// The derivative of e^{E s} x is a block of the exponential of [E s, (E s)'; 0, E s].
std::optional<Deviations> linear_spring_parameter_deviation(const System& system,
                                                            const System& tangent,
                                                            const SpringArc& phase,
                                                            const State& start, double theta,
                                                            double s, const Deviations& column) {
  const Index n = start.q.size();
  if (phase.depth_observables.empty() || !phase.closed().empty() || n > kMostModes ||
      system.harmonics())
    return {};
  std::vector<SpringRates> springs;
  for (std::size_t k = 0; k < phase.springs().loaded.size(); ++k) {
    const auto at = static_cast<std::size_t>(phase.springs().loaded[k]);
    springs.push_back({system.stops[at], tangent.stops[at], phase.depths[k]});
    // The derivative by the exponent of a spring is not linear.
    if (tangent.stops[at].is_compliant() && tangent.stops[at].force().exponent != 0.0) return {};
  }
  const Equations equations = equations_of(system, springs, start.q);
  const Equations rates = rates_of(system, tangent, springs, start.q);
  const Vector quickest = equations.stiffness.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Vector scale = quickest.cwiseMax(std::max(equations.frequency, 1e-3 * quickest.maxCoeff()));
  const Matrix e = s * equations.generator(scale, 1.0);
  const double s_rate = -s * tangent.forcing()->frequency / equations.frequency;
  const Index m = 2 * n + 3;
  Matrix block = Matrix::Zero(2 * m, 2 * m);
  block.topLeftCorner(m, m) = block.bottomRightCorner(m, m) = e;
  block.topRightCorner(m, m) =
      s * rates.generator(scale, 0.0) + s_rate * equations.generator(scale, 1.0);
  Vector x = Vector::Zero(2 * m);
  x.head(2 * n) << scale.cwiseProduct(column.q.col(0)), column.qdot.col(0);
  x.segment(m + n, n) = start.qdot;
  x.tail(3) << std::cos(theta), std::sin(theta), 1.0;
  const Vector moved = matrix_exponential(block) * x;
  return Deviations{moved.head(n).cwiseQuotient(scale), moved.segment(n, n),
                    Eigen::RowVectorXd::Zero(1)};
}

}  // namespace graze
