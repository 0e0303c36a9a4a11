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
  double delta, force, frequency, load;
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
  const Eigen::Vector2d rest(mode.offset, 0.0);
  const Eigen::Vector2d free = start - rest - harmonic(forced, i_frequency * forced, theta);

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
  const Eigen::Vector2d rest_rate(w2 > 0.0 ? (rate.load - mode.offset * rate.stiffness) / w2 : 0.0,
                                  0.0);
  return e_rate * free - e * (rest_rate + harmonic(forced_rate, velocity_rate, theta)) + rest_rate +
         harmonic(forced_rate, velocity_rate, theta_end);
}

// A resonant mode has no harmonic response to lean on, a soft one no rest position: derivative of
// the exponential of the system (q, q', cos, sin, 1) through the block matrix [A, dA; 0, A].
Eigen::Vector2d direct_mode_tangent(const ModeFlow<double>& mode, double load,
                                    const ModeRates& rate, double frequency,
                                    const Eigen::Vector2d& start, double theta, double s) {
  using Matrix5 = Eigen::Matrix<double, 5, 5>;
  const auto generator = [](const ModeRates& of, double w, double one) {
    Matrix5 a = Matrix5::Zero();
    a(0, 1) = one;
    a(1, 0) = -of.stiffness;
    a(1, 1) = -2.0 * of.delta;
    a(1, 2) = of.force;
    a(1, 4) = of.load;
    a(2, 3) = -w;
    a(3, 2) = w;
    return a;
  };
  // The phases at both ends are kept, so the clock runs in forcing phase: A s with s = phase/W.
  const double s_rate = -s * rate.frequency / frequency;
  const ModeRates here{mode.omega * mode.omega, mode.delta, mode.force, frequency, load};
  const Matrix5 a = generator(here, frequency, 1.0);
  const Matrix5 a_rate = generator(rate, rate.frequency, 0.0);
  Matrix block = Matrix::Zero(10, 10);
  block.topLeftCorner(5, 5) = a * s;
  block.bottomRightCorner(5, 5) = a * s;
  block.topRightCorner(5, 5) = a_rate * s + a * s_rate;
  Eigen::Matrix<double, 5, 1> state;
  state << start[0], start[1], std::cos(theta), std::sin(theta), 1.0;
  const Matrix exponential = matrix_exponential(block);
  return (exponential.topRightCorner(5, 5) * state).head(2);
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
  if (system.load) acceleration += *system.load;
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
    const State loaded = load_response(system, flow, s);
    result.phase_rate.q -= loaded.q;
    result.phase_rate.qdot -= loaded.qdot;
  }
  return result;
}

State load_response(const System& system, const ExactFlow<double>& flow, double s) {
  const Eigen::Index n = system.modes();
  State response{Vector::Zero(n), Vector::Zero(n)};
  if (!system.load) return response;
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    response.q[j] = (*system.load)[j] * step_response(mode.delta, mode.omega, mode.discriminant, s);
    response.qdot[j] = (*system.load)[j] * free_basis(mode.delta, mode.discriminant, s).sine;
  }
  return response;
}

State end_tangent(const System& system, const System& tangent, const ExactFlow<double>& flow,
                  const State& start, double theta, double s) {
  const Eigen::Index n = system.modes();
  const double frequency = system.forcing->frequency;
  State rate{Vector(n), Vector(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    const double load = system.load ? (*system.load)[j] : 0.0;
    const ModeRates rates{2.0 * system.omega[j] * tangent.omega[j], tangent.delta[j],
                          tangent.forcing->amplitude[j], tangent.forcing->frequency,
                          tangent.load ? (*tangent.load)[j] : 0.0};
    const Eigen::Vector2d from(start.q[j], start.qdot[j]);
    // With no load there is nothing for a soft mode to rest against.
    const bool soft = mode.omega == 0.0 ? load != 0.0 || rates.load != 0.0 : mode.load != 0.0;
    const Eigen::Vector2d end =
        mode.kind == ModeKind::kResonant || soft
            ? direct_mode_tangent(mode, load, rates, frequency, from, theta, s)
            : harmonic_mode_tangent(mode, rates, frequency, from, theta, s);
    rate.q[j] = end[0];
    rate.qdot[j] = end[1];
  }
  return rate;
}

}  // namespace graze
