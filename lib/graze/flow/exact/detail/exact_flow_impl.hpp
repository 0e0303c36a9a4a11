// Definitions of exact_flow.hpp; included by one translation unit per scalar.
#pragma once

#include <array>
#include <limits>
#include <type_traits>

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/exact/detail/forced_response_impl.hpp"
#include "graze/flow/exact/detail/free_basis.hpp"
#include "graze/flow/exact/detail/term_kernels.hpp"

namespace graze {
namespace exact_flow_detail {

// turn_terms() for a scalar that no vector unit knows.
template <class Real>
void turn_terms(const Real* decay, const Real* half_frequency, std::size_t count, const Real&,
                const Real& s, Real* re_minus_one, Real* im) {
  using std::cos, std::expm1, std::sin;
  for (std::size_t i = 0; i < count; ++i) {
    const Real half = half_frequency[i] * s, sine = sin(half), cosine = cos(half);
    const Real lost = expm1(-decay[i] * s);
    const Real twice = 2 * (1 + lost) * sine;
    re_minus_one[i] = lost - twice * sine;
    im[i] = twice * cosine;
  }
}

// A response P_j beyond this many times the reach of the stops is taken from rest as well: its
// rounding would be 1e-12 of the reach. (Below, P_j is of ordinary size: the motion away from a
// stop.) Where every gap is 0 the size of the state replaces the reach.
inline constexpr double kFarthestResponse = 4096.0;

// The two exponentials of a mode count as distinct when their rates differ by at least this part of
// omega (one bit lost) and of the forcing frequency (six bits lost over a period).
inline constexpr double kSeparationByOmega = 0.5;
inline constexpr double kSeparationByForcing = 1.0 / 64.0;

// A mode up to this many times slower than the forcing moves at least 2 pi^2/256 of the way to its
// rest position in a forcing period.
inline constexpr double kSlowestToRefer = 16.0;

// Whether the rest position under a load is near enough to refer to.
template <class Real>
bool rests_within_reach(const Real& load, const Real& omega, const Real& reach) {
  using std::abs;
  return abs(load) <= kLargestAmplification * reach * omega * omega;
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
void classify_forced(ModeFlow<Real>& mode, const Real& frequency, const Real& reach) {
  using std::abs;
  const Real stiffness = mode.omega * mode.omega;
  const PlanarNumber<Real> impedance{(mode.omega - frequency) * (mode.omega + frequency),
                                     2 * mode.delta * frequency};
  const Real norm = impedance.re * impedance.re + impedance.im * impedance.im;
  const Real limit = stiffness / kLargestAmplification;
  const Real farthest = kFarthestResponse * reach;
  const bool is_far = reach > 0 && mode.force * mode.force > farthest * farthest * norm;
  if (norm < limit * limit || is_far)
    mode.kind = ModeKind::kFromRest;
  else
    mode.forced = PlanarNumber<Real>{mode.force, 0} / impedance;
}

template <class Real>
void classify_load(ModeFlow<Real>& mode, const Real& load, const Real& frequency,
                   const Real& reach) {
  using std::isfinite;
  if (load == 0) return;
  // Without stops, the size of the motion is what the load moves it by in a forcing period.
  const bool is_near = isfinite(reach) ? rests_within_reach(load, mode.omega, reach)
                                       : frequency > 0 && kSlowestToRefer * mode.omega >= frequency;
  const bool has_rest = mode.omega > 0 && is_near;
  if (has_rest) {
    mode.offset = load / (mode.omega * mode.omega);
  } else {
    mode.load = load;
    // The basis that holds for any damping.
    if (mode.kind != ModeKind::kFromRest) mode.kind = ModeKind::kNearCritical;
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
    if (system.repeats) period_ = 2 * acos(Real(-1)) / frequency_;
  }
  for (Eigen::Index j = 0; j < system.omega.size(); ++j) {
    ModeFlow<Real> mode;
    mode.omega = system.omega[j];
    mode.delta = system.delta[j];
    exact_flow_detail::classify_free(mode, frequency_);
    if (forced_) {
      mode.force = system.amplitude[j];
      exact_flow_detail::classify_forced(mode, frequency_, system.reach);
    }
    if (system.load.size() > 0)
      exact_flow_detail::classify_load(mode, system.load[j], frequency_, system.reach);
    modes_.push_back(mode);
  }
  note_turns();
  if (forced_ && !(system.reach > 0)) add_from_rest(system);
}

template <class Real>
void ExactFlow<Real>::note_turns() {
  const std::size_t length = column_length(modes_.size() + 1);
  turns_.decay.assign(length, 0);
  turns_.half_frequency.assign(length, 0);
  turns_.half_frequency[0] = frequency_ / 2;
  for (std::size_t j = 0; j < modes_.size(); ++j) {
    if (modes_[j].kind != ModeKind::kOscillatory) continue;
    turns_.decay[j + 1] = modes_[j].first;
    turns_.half_frequency[j + 1] = modes_[j].second / 2;
  }
  turns_.quickest = *std::max_element(turns_.half_frequency.begin(), turns_.half_frequency.end());
}

template <class Real>
void ExactFlow<Real>::add_from_rest(const LinearSystem<Real>& system) {
  using std::sqrt;
  push_ = system.amplitude.norm() + (system.load.size() > 0 ? system.load.norm() : Real(0));
  ExactFlow<Real> from_rest = *this;
  for (ModeFlow<Real>& mode : from_rest.modes_) {
    const PlanarNumber<Real> response = mode.forced;
    if (response.re == 0 && response.im == 0) continue;
    farthest_response_ = std::max<Real>(
        farthest_response_, sqrt(response.re * response.re + response.im * response.im));
    mode.forced = {};
    mode.kind = ModeKind::kFromRest;
  }
  from_rest.note_turns();
  from_rest_ = std::make_shared<const ExactFlow<Real>>(std::move(from_rest));
}

template <class Real>
const ExactFlow<Real>& ExactFlow<Real>::for_start(const RealVector<Real>& q,
                                                  const RealVector<Real>& qdot) const {
  if (!from_rest_) return *this;
  // The motion is that large already, or starts at a speed with which it rises so far against the
  // load.
  const Real height = qdot.squaredNorm() / (2 * push_);
  const Real reach = std::max<Real>(q.norm(), height);
  return farthest_response_ > exact_flow_detail::kFarthestResponse * reach ? *from_rest_ : *this;
}

template <class Real>
Arc<Real>::Arc(const ExactFlow<Real>& flow)
    : whole_flow_(&flow), flow_(&flow), amplitudes_(static_cast<std::size_t>(flow.modes())) {}

template <class Real>
void Arc<Real>::start(const Real& theta, const RealVector<Real>& q, const RealVector<Real>& qdot) {
  using std::cos, std::sin;
  flow_ = &whole_flow_->for_start(q, qdot);
  theta_ = theta;
  start_ = q;
  start_rate_ = qdot;
  if (flow_->forced()) turn_ = {cos(theta), sin(theta)};
  const Real &c = turn_.re, &n = turn_.im;
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
    // Counted from the start, with the acceleration there: nothing cancels in a soft mode.
    const FreeBasis<Real> basis = free_basis(mode.omega, mode.delta, mode.discriminant, s);
    const Real push = mode.load - mode.omega * mode.omega * a.re;
    y = a.re + push * step_response(mode.omega, mode.delta, mode.discriminant, s) +
        a.im * basis.sine;
    ydot = a.im * (basis.cosine - mode.delta * basis.sine) + push * basis.sine;
    if (mode.kind == ModeKind::kFromRest) {
      const PlanarNumber<Real> x = forced_response(mode, frequency, theta_, s);
      y += mode.force * x.re;
      ydot += mode.force * x.im;
    }
  }
  q = y + mode.offset + mode.forced.re * c - mode.forced.im * n;
  qdot = ydot - frequency * (mode.forced.re * n + mode.forced.im * c);
}

template <class Real>
void Arc<Real>::state(const Real& s, RealVector<Real>& q, RealVector<Real>& qdot) const {
  using exact_flow_detail::turn_terms, graze::turn_terms;
  constexpr int kBlock = 64;        // columns
  std::array<Real, kBlock> re, im;  // e^{l s} - 1
  const typename ExactFlow<Real>::Turns& turns = flow_->turns();
  const Real frequency = flow_->frequency();
  Real c = 0, n = 0;
  const int columns = flow_->modes() + 1;
  for (int first = 0; first < columns; first += kBlock) {
    const int count = std::min(kBlock, columns - first);
    turn_terms(turns.decay.data() + first, turns.half_frequency.data() + first,
               static_cast<std::size_t>(count), turns.quickest, s, re.data(), im.data());
    if (first == 0 && flow_->forced()) {
      c = turn_.re + (turn_.re * re[0] - turn_.im * im[0]);
      n = turn_.im + (turn_.im * re[0] + turn_.re * im[0]);
    }
    for (int i = first == 0 ? 1 : 0; i < count; ++i) {
      const int j = first + i - 1;
      const ModeFlow<Real>& mode = flow_->mode(j);
      if (mode.kind != ModeKind::kOscillatory) {
        mode_state(j, s, c, n, q[j], qdot[j]);
        continue;
      }
      const auto place = static_cast<std::size_t>(i);
      const PlanarNumber<Real>& a = amplitudes_[static_cast<std::size_t>(j)];
      const Real y = a.re + (a.re * re[place] - a.im * im[place]);
      const Real across = a.im + (a.re * im[place] + a.im * re[place]);
      q[j] = y + mode.offset + mode.forced.re * c - mode.forced.im * n;
      qdot[j] = -mode.delta * y - mode.second * across -
                frequency * (mode.forced.re * n + mode.forced.im * c);
    }
  }
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

}  // namespace graze
