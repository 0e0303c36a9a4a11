#include "graze/flow/transition.hpp"

#include <cmath>
#include <numbers>

#include "graze/base/decompositions.hpp"
#include "graze/flow/free_basis.hpp"

namespace graze {
namespace {

FlowMatrix flow_matrix(const System& system, const ExactFlow<double>& flow, double s) {
  const Eigen::Index n = system.modes();
  FlowMatrix e{Vector(n), Vector(n), Vector(n), Vector(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    const FreeBasis<double> basis = free_basis(mode.delta, mode.discriminant, s);
    e.qq[j] = basis.cosine + mode.delta * basis.sine;
    e.qv[j] = basis.sine;
    e.vq[j] = -mode.omega * mode.omega * basis.sine;
    e.vv[j] = basis.cosine - mode.delta * basis.sine;
  }
  return e;
}

// Derivative of S = e^{-delta s} sin(sqrt(D) s)/sqrt(D) by D: (s c - S)/(2 D), by its series where
// that would cancel (|D| s^2 < 1; the 9th term is below eps).
double sine_by_discriminant(const ModeFlow<double>& mode, const FreeBasis<double>& basis,
                            double s) {
  const double x = mode.discriminant * s * s;
  if (std::abs(x) >= 1.0) return (s * basis.cosine - basis.sine) / (2.0 * mode.discriminant);
  double term = -s * s * s / 6.0, sum = 0.0;  // k-th: (-1)^k k D^{k-1} s^{2k+1}/(2k+1)!
  for (int k = 1; k < 10; ++k) {
    sum += k * term;
    term *= -x / ((2.0 * k + 2.0) * (2.0 * k + 3.0));
  }
  return std::exp(-mode.delta * s) * sum;
}

struct ModeRates {   // of one mode's coefficients
  double stiffness;  // of omega^2
  double delta, force, frequency;
};

// One mode's end, seen as free part about the harmonic response: y1 = E (y0 - p0) + p1.
Eigen::Vector2d harmonic_mode_tangent(const ModeFlow<double>& mode, const ModeRates& rate,
                                      double frequency, const Eigen::Vector2d& start, double theta,
                                      double s) {
  const Complex forced{mode.forced.re, mode.forced.im};
  const Complex impedance{mode.omega * mode.omega - frequency * frequency,
                          2.0 * mode.delta * frequency};
  const Complex forced_rate =
      (rate.force -
       forced * Complex{rate.stiffness - 2.0 * frequency * rate.frequency,
                        2.0 * (frequency * rate.delta + mode.delta * rate.frequency)}) /
      impedance;
  const auto harmonic = [](Complex displacement, Complex velocity, double phase) {
    const Complex turn = std::polar(1.0, phase);
    return Eigen::Vector2d((displacement * turn).real(), (velocity * turn).real());
  };
  const Complex i_frequency{0.0, frequency};
  const Complex velocity_rate = i_frequency * forced_rate + Complex{0.0, rate.frequency} * forced;
  const double theta_end = theta + frequency * s;
  const Eigen::Vector2d free = start - harmonic(forced, i_frequency * forced, theta);

  const double w2 = mode.omega * mode.omega;
  const FreeBasis<double> basis = free_basis(mode.delta, mode.discriminant, s);
  // d c and d S through delta, D = w^2 - delta^2 and, at fixed end phase, the duration.
  const double discriminant_rate = rate.stiffness - 2.0 * mode.delta * rate.delta;
  const double s_rate = -s * rate.frequency / frequency;
  const double c_rate = -s * basis.cosine * rate.delta - 0.5 * s * basis.sine * discriminant_rate -
                        s_rate * (mode.delta * basis.cosine + mode.discriminant * basis.sine);
  const double sine_rate = -s * basis.sine * rate.delta +
                           sine_by_discriminant(mode, basis, s) * discriminant_rate +
                           s_rate * (basis.cosine - mode.delta * basis.sine);
  const double mixed_rate = rate.delta * basis.sine + mode.delta * sine_rate;
  Eigen::Matrix2d e, e_rate;
  e << basis.cosine + mode.delta * basis.sine, basis.sine, -w2 * basis.sine,
      basis.cosine - mode.delta * basis.sine;
  e_rate << c_rate + mixed_rate, sine_rate, -rate.stiffness * basis.sine - w2 * sine_rate,
      c_rate - mixed_rate;
  return e_rate * free - e * harmonic(forced_rate, velocity_rate, theta) +
         harmonic(forced_rate, velocity_rate, theta_end);
}

// A resonant mode has no harmonic response to lean on: derivative of the exponential of the system
// (q, q', cos, sin) through the block matrix [A, dA; 0, A].
Eigen::Vector2d resonant_mode_tangent(const ModeFlow<double>& mode, const ModeRates& rate,
                                      double frequency, const Eigen::Vector2d& start, double theta,
                                      double s) {
  const auto generator = [](double stiffness, double delta, double force, double w, double one) {
    Eigen::Matrix4d a;
    a << 0, one, 0, 0, -stiffness, -2.0 * delta, force, 0, 0, 0, 0, -w, 0, 0, w, 0;
    return a;
  };
  // The phases at both ends are kept, so the clock runs in forcing phase: A s with s = phase/W.
  const double s_rate = -s * rate.frequency / frequency;
  const Eigen::Matrix4d a =
      generator(mode.omega * mode.omega, mode.delta, mode.force, frequency, 1.0);
  const Eigen::Matrix4d a_rate =
      generator(rate.stiffness, rate.delta, rate.force, rate.frequency, 0.0);
  Matrix block = Matrix::Zero(8, 8);
  block.topLeftCorner(4, 4) = a * s;
  block.bottomRightCorner(4, 4) = a * s;
  block.topRightCorner(4, 4) = a_rate * s + a * s_rate;
  const Eigen::Vector4d state(start[0], start[1], std::cos(theta), std::sin(theta));
  const Matrix exponential = matrix_exponential(block);
  return (exponential.topRightCorner(4, 4) * state).head(2);
}

}  // namespace

Matrix FlowMatrix::times(const Matrix& right) const {
  const Eigen::Index n = qq.size();
  Matrix product(2 * n, right.cols());
  product.topRows(n) = qq.asDiagonal() * right.topRows(n);
  product.topRows(n) += qv.asDiagonal() * right.bottomRows(n);
  product.bottomRows(n) = vq.asDiagonal() * right.topRows(n);
  product.bottomRows(n) += vv.asDiagonal() * right.bottomRows(n);
  return product;
}

State vector_field(const System& system, const State& state, double theta) {
  Vector acceleration =
      -2.0 * system.delta.cwiseProduct(state.qdot) - system.omega.cwiseAbs2().cwiseProduct(state.q);
  if (system.forcing) acceleration += system.forcing->amplitude * std::cos(theta);
  return {state.qdot, acceleration};
}

Transition transition(const System& system, const ExactFlow<double>& flow, const State& start,
                      double theta, double s) {
  const Eigen::Index n = system.modes();
  Transition result;
  result.flow = flow_matrix(system, flow, s);
  Arc<double> arc(flow);
  arc.start(theta, start.q, start.qdot);
  result.end = {Vector(n), Vector(n)};
  arc.state(s, result.end.q, result.end.qdot);
  const double theta_end = system.forcing ? theta + system.forcing->frequency * s : 0.0;
  result.end_rate = vector_field(system, result.end, theta_end);
  // The forced response from rest is linear in (cos, sin) of the start phase; its derivative is
  // the response a quarter turn later.
  result.phase_rate = {Vector::Zero(n), Vector::Zero(n)};
  if (system.forcing) {
    arc.start(theta + 0.5 * std::numbers::pi, Vector::Zero(n), Vector::Zero(n));
    arc.state(s, result.phase_rate.q, result.phase_rate.qdot);
  }
  return result;
}

State end_tangent(const System& system, const System& tangent, const ExactFlow<double>& flow,
                  const State& start, double theta, double s) {
  const Eigen::Index n = system.modes();
  const double frequency = system.forcing->frequency;
  State rate{Vector(n), Vector(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    const ModeRates rates{2.0 * system.omega[j] * tangent.omega[j], tangent.delta[j],
                          tangent.forcing->amplitude[j], tangent.forcing->frequency};
    const Eigen::Vector2d from(start.q[j], start.qdot[j]);
    const Eigen::Vector2d end = mode.kind == ModeKind::kResonant
                                    ? resonant_mode_tangent(mode, rates, frequency, from, theta, s)
                                    : harmonic_mode_tangent(mode, rates, frequency, from, theta, s);
    rate.q[j] = end[0];
    rate.qdot[j] = end[1];
  }
  return rate;
}

}  // namespace graze
