#include "graze/flow/variation/detail/transition.hpp"

#include <cmath>
#include <numbers>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/flow/exact/detail/forced_response.hpp"
#include "graze/flow/exact/detail/free_basis.hpp"

namespace graze {
namespace {

// The flow over s seconds of the free motion that starts with (y, ydot), and where that ends.
void set_free(const ModeFlow<double>& mode, double s, double y, double ydot, ModeTransition& arc) {
  if (mode.kind == ModeKind::kOscillatory) {
    const double decay = std::exp(-mode.delta * s), angle = mode.second * s;
    const double c = decay * std::cos(angle), n = decay * std::sin(angle);
    arc.basis = {c - 1.0, c, n / mode.second};
    const double lag = (ydot + mode.delta * y) / mode.second;
    arc.q = y * c + lag * n;
    arc.qdot = mode.second * (lag * c - y * n) - mode.delta * arc.q;
  } else {
    arc.basis = free_basis(mode.omega, mode.delta, mode.discriminant, s);
  }
  const FreeBasis<double>& basis = arc.basis;
  arc.qq = basis.cosine + mode.delta * basis.sine;
  arc.qv = basis.sine;
  arc.vq = -mode.omega * mode.omega * basis.sine;
  arc.vv = basis.cosine - mode.delta * basis.sine;
  if (mode.kind == ModeKind::kOverdamped) {
    const double spread = mode.second - mode.first;
    const double slow = (ydot + mode.second * y) / spread * std::exp(-mode.first * s);
    const double fast = -(ydot + mode.first * y) / spread * std::exp(-mode.second * s);
    arc.q = slow + fast;
    arc.qdot = -mode.first * slow - mode.second * fast;
  } else if (mode.kind != ModeKind::kOscillatory) {
    arc.q = arc.qq * y + arc.qv * ydot;
    arc.qdot = arc.vq * y + arc.vv * ydot;
  }
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

ModeRates rates_of(const System& system, const System& tangent, Eigen::Index j) {
  return {2.0 * system.omega[j] * tangent.omega[j], tangent.delta()[j],
          tangent.forcing()->amplitude[j], tangent.forcing()->frequency,
          tangent.load() ? (*tangent.load())[j] : 0.0};
}

// The forcing phase at both ends of an arc.
struct EndPhases {
  double start_cosine, start_sine, end_cosine, end_sine;
};

// Derivative of one mode's flow matrix through delta, D = w^2 - delta^2 and, at fixed phases of
// both ends, the duration.
Eigen::Matrix2d mode_flow_tangent(const ModeFlow<double>& mode, const ModeRates& rate,
                                  double frequency, double s, const FreeBasis<double>& basis) {
  const double discriminant_rate = rate.stiffness - 2.0 * mode.delta * rate.delta;
  const double s_rate = -s * rate.frequency / frequency;
  const double c_rate = -s * basis.cosine * rate.delta - 0.5 * s * basis.sine * discriminant_rate -
                        s_rate * (mode.delta * basis.cosine + mode.discriminant * basis.sine);
  const double sine_rate = -s * basis.sine * rate.delta +
                           sine_by_discriminant(mode, basis, s) * discriminant_rate +
                           s_rate * (basis.cosine - mode.delta * basis.sine);
  const double mixed_rate = rate.delta * basis.sine + mode.delta * sine_rate;
  Eigen::Matrix2d rates;
  rates << c_rate + mixed_rate, sine_rate,
      -rate.stiffness * basis.sine - mode.omega * mode.omega * sine_rate, c_rate - mixed_rate;
  return rates;
}

// One mode's end, seen as free part about the harmonic response: y1 = E (y0 - p0) + p1.
Eigen::Vector2d harmonic_mode_tangent(const ModeFlow<double>& mode, const ModeRates& rate,
                                      double frequency, const Eigen::Vector2d& start,
                                      const EndPhases& at, double s,
                                      const FreeBasis<double>& basis) {
  const Complex forced{mode.forced.re, mode.forced.im};
  const Complex impedance{mode.omega * mode.omega - frequency * frequency,
                          2.0 * mode.delta * frequency};
  const Complex forced_rate =
      (rate.force -
       forced * Complex{rate.stiffness - 2.0 * frequency * rate.frequency,
                        2.0 * (frequency * rate.delta + mode.delta * rate.frequency)}) /
      impedance;
  const auto harmonic = [](Complex displacement, Complex velocity, double c, double n) {
    return Eigen::Vector2d(displacement.real() * c - displacement.imag() * n,
                           velocity.real() * c - velocity.imag() * n);
  };
  const Complex i_frequency{0.0, frequency};
  const Complex velocity_rate = i_frequency * forced_rate + Complex{0.0, rate.frequency} * forced;
  const Eigen::Vector2d rest(mode.offset, 0.0);
  const Eigen::Vector2d free =
      start - rest - harmonic(forced, i_frequency * forced, at.start_cosine, at.start_sine);

  const double w2 = mode.omega * mode.omega;
  Eigen::Matrix2d e;
  e << basis.cosine + mode.delta * basis.sine, basis.sine, -w2 * basis.sine,
      basis.cosine - mode.delta * basis.sine;
  const Eigen::Matrix2d e_rate = mode_flow_tangent(mode, rate, frequency, s, basis);
  const Eigen::Vector2d rest_rate(w2 > 0.0 ? (rate.load - mode.offset * rate.stiffness) / w2 : 0.0,
                                  0.0);
  return e_rate * free -
         e * (rest_rate + harmonic(forced_rate, velocity_rate, at.start_cosine, at.start_sine)) +
         rest_rate + harmonic(forced_rate, velocity_rate, at.end_cosine, at.end_sine);
}

// For a mode whose response is taken from rest there is no harmonic response to refer to, for a
// soft one no rest position: derivative of the exponential of the system (q, q', cos, sin, 1)
// through the block matrix [A, dA; 0, A].
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
      -system.resistance(state.qdot) - system.omega.cwiseAbs2().cwiseProduct(state.q);
  if (system.forcing()) acceleration += system.forcing()->at(theta);
  if (system.load()) acceleration += *system.load();
  return {state.qdot, acceleration};
}

ModalTransitions::ModalTransitions(const System& system, const ExactFlow<double>& flow,
                                   double theta, double s)
    : system_(system), flow_(flow), theta_(theta), s_(s) {
  if (!system.forcing()) return;
  const double theta_end = theta + system.forcing()->frequency * s;
  start_cosine_ = std::cos(theta);
  start_sine_ = std::sin(theta);
  end_cosine_ = std::cos(theta_end);
  end_sine_ = std::sin(theta_end);
}

ModeTransition ModalTransitions::from(Eigen::Index j, double q, double qdot) const {
  const ModeFlow<double>& mode = flow_.mode(static_cast<int>(j));
  const double w = flow_.frequency();
  // The harmonic response and its derivative by the phase, at either end.
  const double re = mode.forced.re, im = mode.forced.im;
  const double before = re * start_cosine_ - im * start_sine_;
  const double before_rate = -(re * start_sine_ + im * start_cosine_);
  const double after = re * end_cosine_ - im * end_sine_;
  const double after_rate = -(re * end_sine_ + im * end_cosine_);

  ModeTransition arc;
  set_free(mode, s_, q - mode.offset - before, qdot - w * before_rate, arc);
  arc.q += mode.offset + after;
  arc.qdot += w * after_rate;
  arc.phase_rate_q = after_rate - (arc.qq * before_rate - arc.qv * w * before);
  arc.phase_rate_qdot = -w * after - (arc.vq * before_rate - arc.vv * w * before);
  if (mode.kind == ModeKind::kFromRest) {
    const PlanarNumber<double> now = forced_response(mode, w, theta_, s_);
    // Linear in (cos, sin) of the start phase: its derivative is the response a quarter period
    // later.
    const PlanarNumber<double> later =
        forced_response(mode, w, theta_ + 0.5 * std::numbers::pi, s_);
    arc.q += mode.force * now.re;
    arc.qdot += mode.force * now.im;
    arc.phase_rate_q += mode.force * later.re;
    arc.phase_rate_qdot += mode.force * later.im;
  }
  if (mode.load != 0.0) {
    arc.q += mode.load * step_response(mode.omega, mode.delta, mode.discriminant, s_);
    arc.qdot += mode.load * arc.basis.sine;
  }
  arc.acceleration = -2.0 * mode.delta * arc.qdot - mode.omega * mode.omega * arc.q;
  if (system_.forcing()) arc.acceleration += system_.forcing()->amplitude[j] * end_cosine_;
  if (system_.load()) arc.acceleration += (*system_.load())[j];
  return arc;
}

Eigen::Vector2d ModalTransitions::tangent(Eigen::Index j, double q, double qdot,
                                          const ModeTransition& of, const System& tangent) const {
  const ModeFlow<double>& mode = flow_.mode(static_cast<int>(j));
  const double load = system_.load() ? (*system_.load())[j] : 0.0;
  const ModeRates rates = rates_of(system_, tangent, j);
  const Eigen::Vector2d start(q, qdot);
  // Under a load a soft mode has no rest position.
  const bool soft = mode.omega == 0.0 ? load != 0.0 || rates.load != 0.0 : mode.load != 0.0;
  const double frequency = flow_.frequency();
  if (mode.kind == ModeKind::kFromRest || soft)
    return direct_mode_tangent(mode, load, rates, frequency, start, theta_, s_);
  return harmonic_mode_tangent(mode, rates, frequency, start,
                               {start_cosine_, start_sine_, end_cosine_, end_sine_}, s_, of.basis);
}

Eigen::Matrix2d ModalTransitions::flow_tangent(Eigen::Index j, const ModeTransition& of,
                                               const System& tangent) const {
  return mode_flow_tangent(flow_.mode(static_cast<int>(j)), rates_of(system_, tangent, j),
                           flow_.frequency(), s_, of.basis);
}

FlowMatrix flow_matrix(const System& system, const ExactFlow<double>& flow, double s) {
  const Eigen::Index n = system.modes();
  FlowMatrix e{Vector(n), Vector(n), Vector(n), Vector(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    ModeTransition arc;
    set_free(flow.mode(static_cast<int>(j)), s, 0.0, 0.0, arc);
    e.qq[j] = arc.qq;
    e.qv[j] = arc.qv;
    e.vq[j] = arc.vq;
    e.vv[j] = arc.vv;
  }
  return e;
}

Transition transition(const System& system, const ExactFlow<double>& flow, const State& start,
                      double theta, double s) {
  const Eigen::Index n = system.modes();
  const auto empty = [n] { return State{Vector(n), Vector(n)}; };
  Transition result{empty(), empty(), {Vector(n), Vector(n), Vector(n), Vector(n)}, empty()};
  const ModalTransitions modes(system, flow, theta, s);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeTransition arc = modes.from(j, start.q[j], start.qdot[j]);
    result.end.q[j] = arc.q;
    result.end.qdot[j] = arc.qdot;
    result.end_rate.q[j] = arc.qdot;
    result.end_rate.qdot[j] = arc.acceleration;
    result.flow.qq[j] = arc.qq;
    result.flow.qv[j] = arc.qv;
    result.flow.vq[j] = arc.vq;
    result.flow.vv[j] = arc.vv;
    result.phase_rate.q[j] = arc.phase_rate_q;
    result.phase_rate.qdot[j] = arc.phase_rate_qdot;
  }
  return result;
}

State load_response(const System& system, const ExactFlow<double>& flow, double s) {
  const Eigen::Index n = system.modes();
  State response{Vector::Zero(n), Vector::Zero(n)};
  if (!system.load()) return response;
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    response.q[j] =
        (*system.load())[j] * step_response(mode.omega, mode.delta, mode.discriminant, s);
    response.qdot[j] =
        (*system.load())[j] * free_basis(mode.omega, mode.delta, mode.discriminant, s).sine;
  }
  return response;
}

State end_tangent(const System& system, const System& tangent, const ExactFlow<double>& flow,
                  const State& start, double theta, double s) {
  const Eigen::Index n = system.modes();
  State rate{Vector(n), Vector(n)};
  const ModalTransitions modes(system, flow, theta, s);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeTransition arc = modes.from(j, start.q[j], start.qdot[j]);
    const Eigen::Vector2d end = modes.tangent(j, start.q[j], start.qdot[j], arc, tangent);
    rate.q[j] = end[0];
    rate.qdot[j] = end[1];
  }
  return rate;
}

}  // namespace graze
