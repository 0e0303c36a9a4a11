#include "graze/flow/variation/detail/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/exact/detail/forced_response.hpp"
#include "graze/flow/exact/detail/free_basis.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/variation/detail/transition.hpp"

namespace graze {
namespace {

struct ModeGrowth {
  double q = 0.0, qdot = 0.0;
};

// Derivative of the end of a flight from a given state by the instant of its start, per second: the
// response from rest to the rate of the force, -W f sin(theta + W s). Its power series, for x = (2
// delta + omega + W) s < 2, where it converges like x^n/n! and the difference of free and harmonic
// parts would cancel.
ModeGrowth late_start_by_series(const ModeFlow<double>& mode, double frequency, double theta,
                                double s) {
  const double turn = frequency * s, damping = 2.0 * mode.delta * s;
  const double stiffness = mode.omega * mode.omega * s * s;
  const double quarter[] = {-std::sin(theta), -std::cos(theta), std::sin(theta), std::cos(theta)};
  double force = frequency * mode.force * s * s;  // times turn^n/n!
  double before = 0.0, now = 0.0;                 // coefficients n and n + 1, times s^n, s^(n+1)
  ModeGrowth sum;
  const double reach = damping + (mode.omega + frequency) * s;
  // The force itself may pass through zero: its rate, x times as large, has all digits then too.
  constexpr double kLeft = 0x1p-80;
  double share = 1.0;  // x^n/n!, which no coefficient exceeds by its share of the first
  for (int n = 0; share > kLeft; ++n) {
    const double next = (force * quarter[n % 4] - damping * (n + 1) * now - stiffness * before) /
                        ((n + 1) * (n + 2));
    before = now;
    now = next;
    sum.q += now;
    sum.qdot += (n + 2) * now;
    force *= turn / (n + 1);
    share *= reach / (n + 1);
  }
  sum.qdot /= s;
  return sum;
}

// The change of the forcing over an arc of s seconds from forcing phase theta.
struct ForcingTurn {
  double frequency, theta, s;
  Complex start = std::polar(1.0, theta), end = std::polar(1.0, theta + frequency * s);
};

ModeGrowth late_start(const ModeFlow<double>& mode, const FreeBasis<double>& basis,
                      const ForcingTurn& forcing) {
  const double frequency = forcing.frequency, theta = forcing.theta, s = forcing.s;
  if ((2.0 * mode.delta + mode.omega + frequency) * s < 2.0)
    return late_start_by_series(mode, frequency, theta, s);
  if (mode.kind == ModeKind::kFromRest) {
    const PlanarNumber<double> x =
        forced_response(mode, frequency, theta + 0.5 * std::numbers::pi, s);
    return {frequency * mode.force * x.re, frequency * mode.force * x.im};
  }
  const Complex forced{mode.forced.re, mode.forced.im}, rate{0.0, frequency};
  const Complex start = rate * forced * forcing.start, end = rate * forced * forcing.end;
  const double q = start.real(), qdot = (rate * start).real();
  const double w2 = mode.omega * mode.omega;
  return {
      end.real() - (basis.cosine + mode.delta * basis.sine) * q - basis.sine * qdot,
      (rate * end).real() + w2 * basis.sine * q - (basis.cosine - mode.delta * basis.sine) * qdot};
}

// Growth of a deviation by mode: of its displacement by both displacement and velocity, of its
// velocity by both, and of both by the delay.
struct ModalGrowth {
  Eigen::ArrayXd q_by_q, q_by_qdot, qdot_by_q, qdot_by_qdot;
  Vector q_by_delay, qdot_by_delay;
};

ModalGrowth modal_growth_of(const Arc<double>& arc, double s, bool is_late) {
  const ExactFlow<double>& flow = arc.flow();
  const Eigen::Index n = flow.modes();
  ModalGrowth of{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n),
                 Eigen::ArrayXd(n), Vector::Zero(n),   Vector::Zero(n)};
  is_late = is_late && flow.forced() && s > 0.0;
  const ForcingTurn forcing = is_late ? ForcingTurn{flow.frequency(), arc.start_phase(), s}
                                      : ForcingTurn{0.0, 0.0, 0.0, {}, {}};
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(j);
    const FreeBasis<double> basis = free_basis(mode.omega, mode.delta, mode.discriminant, s);
    const double stiffness = mode.omega * mode.omega;
    // c + delta S - 1 is what the stiffness does from rest; formed as the difference it cancels.
    of.q_by_q[j] = -stiffness * step_response(mode.omega, mode.delta, mode.discriminant, s);
    of.q_by_qdot[j] = basis.sine;
    of.qdot_by_q[j] = -stiffness * basis.sine;
    of.qdot_by_qdot[j] = basis.cosine_minus_one - mode.delta * basis.sine;
    if (!is_late) continue;
    const ModeGrowth late = late_start(mode, basis, forcing);
    of.q_by_delay[j] = late.q;
    of.qdot_by_delay[j] = late.qdot;
  }
  return of;
}

// One column at a time: columns are contiguous in memory.
Deviations modal_growth(const Arc<double>& arc, double s, const Deviations& start) {
  const ModalGrowth of = modal_growth_of(arc, s, !start.delay.isZero(0.0));
  Deviations change{Matrix(start.q.rows(), start.count()), Matrix(start.q.rows(), start.count()),
                    Eigen::RowVectorXd::Zero(start.count())};
  for (Eigen::Index k = 0; k < start.count(); ++k) {
    const auto q = start.q.col(k).array(), qdot = start.qdot.col(k).array();
    const double delay = start.delay[k];
    change.q.col(k).array() = of.q_by_qdot * qdot + of.q_by_q * q + of.q_by_delay.array() * delay;
    change.qdot.col(k).array() =
        of.qdot_by_qdot * qdot + of.qdot_by_q * q + of.qdot_by_delay.array() * delay;
  }
  return change;
}

}  // namespace

Deviations growth(const ExactPhase<double>& phase, double s, const Deviations& start) {
  const ConstrainedStructure<double>& structure = phase.structure();
  if (structure.is_free() && phase.arc()) return modal_growth(*phase.arc(), s, start);
  const Matrix& basis = structure.basis;
  Deviations reduced = start;
  if (!structure.is_free()) {
    reduced.q = basis.transpose() * start.q;
    reduced.qdot = basis.transpose() * start.qdot;
  }
  // A later start finds the harmonics elsewhere.
  for (std::size_t k = 0; k < structure.units.size(); ++k) {
    const Eigen::Index at = structure.drive(k), n = start.q.rows();
    const double theta = phase.coupled_arc()->start_phase(), w = structure.reduced.omega[at];
    const Vector none = Vector::Zero(n);
    reduced.q.row(at) = structure.rates(none, theta)[at] * start.delay;
    reduced.qdot.row(at) = -w * w * structure.coordinates(none, theta)[at] * start.delay;
  }
  if (phase.arc()) {
    reduced = modal_growth(*phase.arc(), s, reduced);
  } else {
    const Eigen::Index m = structure.size();
    Matrix both(2 * m, start.count());
    both << reduced.q, reduced.qdot;
    both = phase.coupled_arc()->growth(s, both, start.delay);
    reduced = {both.topRows(m), both.bottomRows(m), Eigen::RowVectorXd::Zero(start.count())};
  }
  if (structure.is_free()) return reduced;
  return {basis * reduced.q, basis * reduced.qdot, reduced.delay};
}

void move_instant(Deviations& deviations, const State& rate, const Eigen::RowVectorXd& shift) {
  deviations.q += rate.q * shift;
  deviations.qdot += rate.qdot * shift;
  deviations.delay += shift;
}

Vector friction_push(const System& system, const std::vector<Contact>& frictions) {
  if (system.frictions.empty()) return {};
  Vector push = Vector::Zero(system.modes());
  for (std::size_t k = 0; k < frictions.size(); ++k) {
    const Friction& friction = system.frictions[k];
    if (friction.stop >= 0) continue;
    if (frictions[k] == Contact::kForward) push -= friction.sliding * friction.row;
    if (frictions[k] == Contact::kBackward) push += friction.sliding * friction.row;
  }
  return push;
}

ForceChange force_change(const System& system, const PhaseKey& key, int friction, double theta,
                         const State& rate) {
  const auto place = std::find(key.closed.begin(), key.closed.end(), friction) - key.closed.begin();
  const Vector share =
      contact_share(system, key.closed).row(place).transpose() / system.row(friction).squaredNorm();
  ForceChange change{-system.omega.cwiseAbs2().cwiseProduct(share),
                     -system.damping().transpose() * share};
  if (const HarmonicForcing* forcing = system.forcing())
    change.by_delay = forcing->frequency * share.dot(forcing->rate_at(theta));
  change.rate = change.by_q.dot(rate.q) + change.by_qdot.dot(rate.qdot) + change.by_delay;
  return change;
}

State held_rate(const System& system, const std::vector<int>& closed, const State& state,
                double theta, const Vector& push) {
  State rate = vector_field(system, state, theta);
  if (push.size() > 0) rate.qdot += push;
  rate.qdot = held(system, closed, rate.qdot);
  return rate;
}

Vector held(const System& system, const std::vector<int>& closed, const Vector& acceleration) {
  if (closed.empty()) return acceleration;
  return acceleration -
         directions_of(system, closed) * (contact_share(system, closed) * acceleration);
}

void hold(const System& system, const std::vector<int>& closed, Deviations& deviations) {
  if (closed.empty() || deviations.count() == 0) return;
  const Matrix rows = rows_of(system, closed), directions = directions_of(system, closed);
  Matrix beyond = rows.transpose() * deviations.q;
  for (std::size_t a = 0; a < closed.size(); ++a)
    if (system.is_friction(closed[a])) beyond.row(static_cast<Eigen::Index>(a)).setZero();
  deviations.q -= rows * LuFactors(rows.transpose() * rows).solve_columns(beyond);
  deviations.qdot -=
      directions *
      LuFactors(rows.transpose() * directions).solve_columns(rows.transpose() * deviations.qdot);
}

}  // namespace graze
