// Definitions of exact_flow.hpp; included by one translation unit per scalar.
#pragma once

#include <limits>

#include "graze/flow/exact_flow.hpp"
#include "graze/flow/free_basis.hpp"

namespace graze {
namespace exact_flow_detail {

// Writing motion as free part plus P_j multiplies rounding by |P_j| w^2/f_j. Up to this factor (8
// of 53 bits) that is accepted; beyond, the mode counts as resonant.
inline constexpr double kLargestAmplification = 256.0;

// The two exponentials of a mode are told apart when their rates differ by at least this part of
// omega (one bit lost) and of the forcing frequency (six bits lost over a period).
inline constexpr double kSeparationByOmega = 0.5;
inline constexpr double kSeparationByForcing = 1.0 / 64.0;

// A mode this much slower than the forcing moves like a free mass over a period: its rest position
// under a constant load is too far away to refer to. Without forcing only w = 0 is.
inline constexpr double kSoftByForcing = 1.0 / 256.0;

template <class Real>
PlanarNumber<Real> times(const PlanarNumber<Real>& a, const PlanarNumber<Real>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

template <class Real>
PlanarNumber<Real> over(const PlanarNumber<Real>& a, const PlanarNumber<Real>& b) {
  const Real norm = b.re * b.re + b.im * b.im;
  return {(a.re * b.re + a.im * b.im) / norm, (a.im * b.re - a.re * b.im) / norm};
}

// e^{(re + i im) s}
template <class Real>
PlanarNumber<Real> exponential(const Real& re, const Real& im, const Real& s) {
  using std::cos, std::exp, std::sin;
  const Real size = exp(re * s);
  return {size * cos(im * s), size * sin(im * s)};
}

// (e^{i W s} - e^{l s})/(i W - l) for l = -delta + i v, without cancellation as l -> i W.
template <class Real>
PlanarNumber<Real> divided_exponential(const Real& delta, const Real& v, const Real& frequency,
                                       const Real& s) {
  using std::cos, std::expm1, std::sin;
  const PlanarNumber<Real> decay = exponential(Real(-delta), v, s);
  const Real detuning = frequency - v;
  if (delta == 0 && detuning == 0) return {decay.re * s, decay.im * s};
  const Real growth = expm1(delta * s), half = sin(detuning * s / 2);
  const PlanarNumber<Real> difference{growth * cos(detuning * s) - 2 * half * half,
                                      (1 + growth) * sin(detuning * s)};
  return over(times(decay, difference), PlanarNumber<Real>{delta, detuning});
}

template <class Real>
void classify_free(ModeFlow<Real>& mode, const Real& frequency) {
  using std::abs, std::sqrt;
  mode.discriminant = (mode.omega - mode.delta) * (mode.omega + mode.delta);
  const Real root = sqrt(abs(mode.discriminant));
  const bool separate = root > 0 && root >= kSeparationByOmega * mode.omega &&
                        root >= kSeparationByForcing * frequency;
  if (!separate) {
    mode.kind = ModeKind::kNearCritical;
  } else if (mode.discriminant > 0) {
    mode.kind = ModeKind::kOscillatory;
    mode.first = mode.delta;
    mode.second = root;
  } else {
    mode.kind = ModeKind::kOverdamped;
    mode.second = mode.delta + root;
    mode.first = mode.omega * mode.omega / mode.second;
  }
}

template <class Real>
void classify_forced(ModeFlow<Real>& mode, const Real& frequency) {
  const Real stiffness = mode.omega * mode.omega;
  const PlanarNumber<Real> impedance{(mode.omega - frequency) * (mode.omega + frequency),
                                     2 * mode.delta * frequency};
  const Real limit = stiffness / kLargestAmplification;
  if (impedance.re * impedance.re + impedance.im * impedance.im < limit * limit) {
    mode.kind = ModeKind::kResonant;
    mode.second = mode.discriminant > 0 ? Real(sqrt(mode.discriminant)) : Real(0);
  } else {
    mode.forced = over(PlanarNumber<Real>{mode.force, 0}, impedance);
  }
}

template <class Real>
void classify_load(ModeFlow<Real>& mode, const Real& load, const Real& frequency) {
  if (load == 0) return;
  if (mode.omega > kSoftByForcing * frequency) {
    mode.offset = load / (mode.omega * mode.omega);
  } else {
    mode.load = load;
    mode.kind = ModeKind::kNearCritical;  // whose basis holds for any damping
  }
}

}  // namespace exact_flow_detail

template <class Real>
ExactFlow<Real>::ExactFlow(const LinearSystem<Real>& system) : forced_(system.forced) {
  using std::acos;
  period_ = std::numeric_limits<Real>::infinity();
  if (forced_) {
    frequency_ = system.frequency;
    phase_ = system.phase;
    period_ = 2 * acos(Real(-1)) / frequency_;
  }
  for (Eigen::Index j = 0; j < system.omega.size(); ++j) {
    ModeFlow<Real> mode;
    mode.omega = system.omega[j];
    mode.delta = system.delta[j];
    exact_flow_detail::classify_free(mode, frequency_);
    if (forced_) {
      mode.force = system.amplitude[j];
      exact_flow_detail::classify_forced(mode, frequency_);
    }
    if (system.load.size() > 0) exact_flow_detail::classify_load(mode, system.load[j], frequency_);
    modes_.push_back(mode);
  }
}

template <class Real>
Arc<Real>::Arc(const ExactFlow<Real>& flow)
    : flow_(&flow), amplitudes_(static_cast<std::size_t>(flow.modes())) {}

template <class Real>
void Arc<Real>::start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot) {
  using std::cos, std::sin;
  theta_ = theta;
  start_ = q;
  start_rate_ = qdot;
  const Real c = flow_->forced() ? Real(cos(theta)) : Real(0);
  const Real n = flow_->forced() ? Real(sin(theta)) : Real(0);
  for (int j = 0; j < flow_->modes(); ++j) {
    const ModeFlow<Real>& mode = flow_->mode(j);
    const Real y = q[j] - mode.offset - (mode.forced.re * c - mode.forced.im * n);
    const Real ydot = qdot[j] + flow_->frequency() * (mode.forced.re * n + mode.forced.im * c);
    PlanarNumber<Real>& amplitude = amplitudes_[static_cast<std::size_t>(j)];
    if (mode.kind == ModeKind::kOscillatory) {
      amplitude = {y, -(ydot + mode.delta * y) / mode.second};
    } else if (mode.kind == ModeKind::kOverdamped) {
      const Real spread = mode.second - mode.first;
      amplitude = {(ydot + mode.second * y) / spread, -(ydot + mode.first * y) / spread};
    } else {
      amplitude = {y, ydot};
    }
  }
}

template <class Real>
PlanarNumber<Real> resonant_response(const ModeFlow<Real>& mode, const Real& frequency,
                                     const Real& theta, const Real& s) {
  using namespace exact_flow_detail;
  using std::cos, std::sin;
  const Real wd = mode.second;
  const PlanarNumber<Real> up = divided_exponential(mode.delta, wd, frequency, s);
  const PlanarNumber<Real> down = divided_exponential(mode.delta, Real(-wd), frequency, s);
  // X = (E(l) - E(l*))/(2 i wd),  X' = (l E(l) - l* E(l*))/(2 i wd)
  const PlanarNumber<Real> numerator{up.re - down.re, up.im - down.im};
  const PlanarNumber<Real> rate{-mode.delta * (up.re - down.re) - wd * (up.im + down.im),
                                -mode.delta * (up.im - down.im) + wd * (up.re + down.re)};
  const Real c = cos(theta), n = sin(theta);
  // Re(e^{i theta} z/(2 i wd)) = (Im z cos + Re z sin)/(2 wd)
  return {(numerator.im * c + numerator.re * n) / (2 * wd), (rate.im * c + rate.re * n) / (2 * wd)};
}

template <class Real>
void Arc<Real>::mode_state(int j, const Real& s, const Real& c, const Real& n, Real& q,
                           Real& qdot) const {
  using std::cos, std::exp, std::sin;
  const Real frequency = flow_->frequency();
  const ModeFlow<Real>& mode = flow_->mode(j);
  const PlanarNumber<Real>& a = amplitudes_[static_cast<std::size_t>(j)];
  Real y, ydot;
  if (mode.kind == ModeKind::kOscillatory) {
    const Real decay = exp(-mode.delta * s);
    const Real cw = decay * cos(mode.second * s), sw = decay * sin(mode.second * s);
    y = a.re * cw - a.im * sw;
    ydot = -mode.delta * y - mode.second * (a.re * sw + a.im * cw);
  } else if (mode.kind == ModeKind::kOverdamped) {
    const Real slow = a.re * exp(-mode.first * s), fast = a.im * exp(-mode.second * s);
    y = slow + fast;
    ydot = -mode.first * slow - mode.second * fast;
  } else {
    const FreeBasis<Real> basis = free_basis(mode.delta, mode.discriminant, s);
    y = a.re * (basis.cosine + mode.delta * basis.sine) + a.im * basis.sine;
    ydot = a.im * (basis.cosine - mode.delta * basis.sine) -
           a.re * mode.omega * mode.omega * basis.sine;
    if (mode.kind == ModeKind::kResonant) {
      const PlanarNumber<Real> x = resonant_response(mode, frequency, theta_, s);
      y += mode.force * x.re;
      ydot += mode.force * x.im;
    }
    if (mode.load != 0) {
      y += mode.load * step_response(mode.delta, mode.omega, mode.discriminant, s);
      ydot += mode.load * basis.sine;
    }
  }
  q = y + mode.offset + mode.forced.re * c - mode.forced.im * n;
  qdot = ydot - frequency * (mode.forced.re * n + mode.forced.im * c);
}

template <class Real>
Real Arc<Real>::mode_velocity(int j, const Real& s) const {
  using std::cos, std::sin;
  const Real theta = theta_ + flow_->frequency() * s;
  Real q, qdot;
  mode_state(j, s, flow_->forced() ? Real(cos(theta)) : Real(0),
             flow_->forced() ? Real(sin(theta)) : Real(0), q, qdot);
  return qdot;
}

template <class Real>
void Arc<Real>::state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const {
  using std::cos, std::sin;
  const Real theta = theta_ + flow_->frequency() * s;
  const Real c = flow_->forced() ? Real(cos(theta)) : Real(0);
  const Real n = flow_->forced() ? Real(sin(theta)) : Real(0);
  for (int j = 0; j < flow_->modes(); ++j) mode_state(j, s, c, n, q[j], qdot[j]);
}

}  // namespace graze
