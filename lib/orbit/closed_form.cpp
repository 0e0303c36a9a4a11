#include "graze/orbit/closed_form.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/flow/transition.hpp"

namespace graze {

std::vector<ImpactPoint> ClosedForm::solutions(double full_gap) const {
  const double gap = full_gap - moved;
  const double size = std::abs(kappa);
  if (!(size >= std::abs(gap)) || size == 0.0) return {};
  // acos loses half its digits where gap -> |kappa|; the sine is formed from the product instead.
  const double half = std::atan2(std::sqrt((size - gap) * (size + gap)), gap);
  std::vector<ImpactPoint> points;
  for (const double sign : {-1.0, 1.0}) {
    const double phase = wrapped(sign * half - std::arg(kappa));
    const Eigen::Index n = response.size() / 2;
    const Vector y = (response * std::polar(1.0, phase)).real();
    points.push_back({phase, {rest.q + y.head(n), rest.qdot + y.tail(n)}});
  }
  return points;
}

ClosedFormAnswer closed_form(const System& system, int stop_index, int period) {
  if (!system.forcing) return {{}, "there is no forcing"};
  if (!system.stops[static_cast<std::size_t>(stop_index)].restitution.is_constant())
    return {{}, "the restitution depends on the speed"};
  const Eigen::Index n = system.modes();
  const ExactFlow<double> flow(system);
  const RigidStop& stop = system.stops[static_cast<std::size_t>(stop_index)];
  const State rest{Vector::Zero(n), Vector::Zero(n)};
  const Transition arc = transition(system, flow, rest, 0.0, period * system.period());
  Matrix jump = Matrix::Identity(2 * n, 2 * n);
  jump.bottomRightCorner(n, n) -=
      (1.0 + stop.restitution.at_rest()) * stop.direction * stop.row.transpose();
  // Velocities in units of each mode's own frequency: the flow then turns and shrinks, no more.
  Vector unit = Vector::Ones(2 * n);
  unit.tail(n) = system.omega.cwiseMax(flow.frequency());
  const Matrix map = unit.cwiseInverse().asDiagonal() * arc.flow.times(jump) * unit.asDiagonal();
  const Eigen::PartialPivLU<Matrix> lu(Matrix::Identity(2 * n, 2 * n) - map);
  // Below this reciprocal condition number the solve keeps no digit.
  if (!(lu.rcond() > std::numeric_limits<double>::epsilon()))
    return {{}, "the motion between impacts repeats by itself (I - E J is singular)"};
  // R(phi) = R(0) cos(phi) + R(pi/2) sin(phi)
  const auto response = [&](const State& forced) {
    Vector y(2 * n);
    y << forced.q, forced.qdot;
    return Vector(lu.solve(y.cwiseQuotient(unit)).cwiseProduct(unit));
  };
  ClosedForm form;
  form.response = ComplexVector(2 * n);
  const State loaded = load_response(system, flow, period * system.period());
  form.response.real() = response({arc.end.q - loaded.q, arc.end.qdot - loaded.qdot});
  form.response.imag() = -response(arc.phase_rate);
  form.rest = {Vector::Zero(n), Vector::Zero(n)};
  if (system.load) {
    const Vector y = response(loaded);
    form.rest = {y.head(n), y.tail(n)};
    form.moved = stop.row.dot(form.rest.q);
  }
  form.kappa = stop.row.cast<Complex>().dot(form.response.head(n));
  return {form, ""};
}

}  // namespace graze
