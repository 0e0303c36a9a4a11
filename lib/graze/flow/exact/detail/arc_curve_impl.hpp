// Definitions of arc_curve.hpp; included by one translation unit per scalar.
#pragma once

#include <limits>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/exact/detail/curve_terms_impl.hpp"
#include "graze/flow/exact/detail/exact_flow_impl.hpp"

namespace graze {
template <class Real>
CurvePoint<Real> observed(const Observable<Real>& observable, const Real& theta,
                          const RealVector<Real>& q, const RealVector<Real>& qdot) {
  using std::abs, std::cos, std::sin;
  Real value = 0, size = abs(observable.constant);
  const auto add = [&](const Real& part) {
    value += part;
    size += abs(part);
  };
  const bool moves = observable.velocity.size() > 0;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    add(observable.displacement[j] * q[j]);
    if (moves) add(observable.velocity[j] * qdot[j]);
  }
  if (observable.harmonic.re != 0 || observable.harmonic.im != 0)
    add(observable.harmonic.re * cos(theta) - observable.harmonic.im * sin(theta));
  const int terms = static_cast<int>(moves ? 2 * q.size() : q.size()) + 2;
  CurvePoint<Real> start;
  // The constant is added last, as wherever a gap is formed, so that all agree bit by bit.
  start.value = observable.constant + value;
  start.noise = Real(terms) * std::numeric_limits<Real>::epsilon() * size;
  return start;
}

template <class Real>
void ArcCurve<Real>::adopt(const ExactFlow<Real>& flow, const Observable<Real>& observable) {
  using std::abs;
  flow_ = &flow;
  frequency_ = flow.frequency();
  terms_.clear();
  sources_.clear();
  specials_.clear();
  const bool moves = observable.velocity.size() > 0;
  harmonic_ = observable.harmonic;
  terms_.reserve(static_cast<std::size_t>(2 * flow.modes() + 1));
  sources_.reserve(static_cast<std::size_t>(2 * flow.modes()));
  const auto add = [&](const Source& source, const Real& decay, const Real& frequency) {
    terms_.add(decay, frequency);
    sources_.push_back(source);
  };
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<Real>& mode = flow.mode(j);
    const Real x = observable.displacement[j], v = moves ? observable.velocity[j] : Real(0);
    const PlanarNumber<Real> forced = PlanarNumber<Real>{x, v * frequency_} * mode.forced;
    harmonic_.re += forced.re;
    harmonic_.im += forced.im;
    // The free part is the state less the forced response and the offset: it carries their
    // rounding.
    const Real apart = abs(mode.forced.re) + abs(mode.forced.im) + abs(mode.offset);
    if (mode.kind == ModeKind::kOscillatory) {
      add({j,
           Takes::kBoth,
           {x - v * mode.first, v * mode.second},
           (abs(x) + abs(v) * mode.omega) * apart * (1 + (frequency_ + mode.first) / mode.second)},
          mode.first, mode.second);
    } else if (mode.kind == ModeKind::kOverdamped) {
      const Real formed_from = apart * (1 + frequency_ / mode.second);
      const Real slow = x - v * mode.first, fast = x - v * mode.second;
      add({j, Takes::kFirst, {slow, 0}, abs(slow) * formed_from}, mode.first, 0);
      add({j, Takes::kSecond, {fast, 0}, abs(fast) * formed_from}, mode.second, 0);
    } else {
      specials_.push_back({&mode, j, x, v, apart});
    }
  }
  modes_end_ = terms_.size();
  if (flow.forced()) terms_.add(0, frequency_);
}

template <class Real>
void ArcCurve<Real>::restart(const Arc<Real>& arc, const Observable<Real>& observable,
                             const Real& window, bool from_zero) {
  if (flow_ != &arc.flow()) adopt(arc.flow(), observable);
  theta_ = arc.start_phase();
  window_ = window;
  start_value_ = start_noise_ = 0;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    const PlanarNumber<Real>& a = arc.amplitude(source.mode);
    const Real& w = source.weight.re;
    const PlanarNumber<Real> k = source.takes == Takes::kBoth    ? source.weight * a
                                 : source.takes == Takes::kFirst ? PlanarNumber<Real>{w * a.re, 0}
                                                                 : PlanarNumber<Real>{w * a.im, 0};
    terms_.set(i, k, source.formed_from);
  }
  for (Special& special : specials_) {
    special.q = arc.amplitude(special.index).re;
    special.qdot = arc.amplitude(special.index).im;
  }
  if (flow_->forced()) terms_.set(modes_end_, harmonic_ * arc.start_turn(), 0);
  if (from_zero) return;
  const CurvePoint<Real> start =
      observed(observable, theta_, arc.start_displacements(), arc.start_velocities());
  start_value_ = start.value;
  start_noise_ = start.noise;
}

template <class Real>
ArcCurve<Real>::ArcCurve(const Real& start, const Real& noise, const Real& window)
    : window_(window), start_value_(start), start_noise_(noise) {}

template <class Real>
void ArcCurve<Real>::add_exponential(const PlanarNumber<Real>& k, const Real& decay,
                                     const Real& frequency, const Real& formed_from) {
  terms_.add(decay, frequency);
  terms_.set(terms_.size() - 1, k, formed_from);
}

template <class Real>
CurvePoint<Real> ArcCurve<Real>::at(const Real& s, int m, Reach reach) const {
  CurvePoint<Real> point;
  point.third = 0;
  TermShares<Real> shares;
  terms_.add_to(s, m, point, shares);
  for (const Special& special : specials_) add_special(special, s, m, reach, point);
  if (m == 0) {
    point.value += start_value_;
    point.noise += start_noise_;
  }
  if (part_) {
    point.third = std::numeric_limits<Real>::infinity();
    part_(s, m, reach, point);
  } else if (reach == Reach::kStep && specials_.empty() && terms_.size() <= kMostShares) {
    leave_out_quick(shares, point);
  }
  return point;
}

// Fast terms of small size have the largest curvature and move the curve least: terms are left out
// from the fastest on while together they cannot take away more than half of what is left.
template <class Real>
void ArcCurve<Real>::leave_out_quick(const TermShares<Real>& shares,
                                     CurvePoint<Real>& point) const {
  const Real most = point.value / 2;
  typename CurvePoint<Real>::Slow slow;
  slow.fall = 0;
  std::size_t kept = modes_end_;
  for (; kept > 0 && slow.fall + shares.fall[kept - 1] <= most; --kept)
    slow.fall += shares.fall[kept - 1];
  if (kept == modes_end_) return;
  for (std::size_t j = 0; j < terms_.size(); ++j) {
    if (j >= kept && j < modes_end_) continue;
    slow.slope += shares.slope[j];
    slow.curvature += shares.curvature[j];
    slow.third += shares.third[j];
  }
  point.slow = slow;
}

// A derivative y of the displacement solves y'' + 2 delta y' + w^2 y = F, the force or a derivative
// of it. From (y, y') here on, with S and c of free_basis.hpp,
//   y'' = y' (c - delta S)' + (F_load - w^2 y)(c - delta S) + (S * F_harmonic)'',
// and |c - delta S| <= 1, |S| <= L = min(1/w, 1/(2 delta), time ahead), |(c - delta S)'| <= r =
// 2 delta + w^2 L. The last term is at most |F| (1 + V), V the variation of c - delta S: r times
// the time ahead; above critical damping it falls from 1, rises once and falls: at most 3.
template <class Real>
typename ArcCurve<Real>::Bounds ArcCurve<Real>::special_bounds(
    const ModeFlow<Real>& mode, const std::array<Real, kOrders + 1>& d, const Real& ahead) const {
  using std::abs;
  const Real w2 = mode.omega * mode.omega, damping = 2 * mode.delta;
  const Real rate = std::max(mode.omega, damping);
  const Real longest = rate * ahead > 1 ? Real(1 / rate) : ahead;
  const Real fastest = damping + w2 * longest;
  Real variation = fastest * ahead;
  if (mode.discriminant <= 0) variation = std::min<Real>(variation, 3);
  Real harmonic =
      mode.kind == ModeKind::kFromRest ? Real(abs(mode.force) * (1 + variation)) : Real(0);
  Bounds bound{};
  for (std::size_t k = 2; k < bound.size(); ++k) {
    const Real own = k == 2 ? Real(mode.load - w2 * d[0]) : Real(w2 * d[k - 2]);
    bound[k] = abs(d[k - 1]) * fastest + abs(own) + harmonic;
    harmonic *= frequency_;
  }
  return bound;
}

template <class Real>
void ArcCurve<Real>::add_special(const Special& special, const Real& s, int m, Reach reach,
                                 CurvePoint<Real>& point) const {
  using std::abs, std::cos, std::sin, std::sqrt;
  const ModeFlow<Real>& mode = *special.mode;
  const Real w2 = mode.omega * mode.omega, damping = 2 * mode.delta;
  const FreeBasis<Real> basis = free_basis(mode.omega, mode.delta, mode.discriminant, s);
  const bool driven = mode.kind == ModeKind::kFromRest;
  const Real push = mode.load - w2 * special.q;
  // Change of displacement and velocity since the start; from the equation of motion the rest.
  Real change = push * step_response(mode.omega, mode.delta, mode.discriminant, s) +
                special.qdot * basis.sine;
  Real rate_change =
      special.qdot * (basis.cosine_minus_one - mode.delta * basis.sine) + push * basis.sine;
  std::array<Real, kOrders> force{};  // and its derivatives
  if (driven) {
    const PlanarNumber<Real> x = forced_response(mode, frequency_, theta_, s);
    change += mode.force * x.re;
    rate_change += mode.force * x.im;
    const Real c = mode.force * cos(theta_ + frequency_ * s);
    const Real n = -mode.force * frequency_ * sin(theta_ + frequency_ * s);
    const Real turn = -frequency_ * frequency_;
    force = {c, n, turn * c, turn * n, turn * turn * c};
  }
  force[0] += mode.load;
  // d[k]: derivative k of the displacement.
  std::array<Real, kOrders + 1> d;
  d[0] = special.q + change;
  d[1] = special.qdot + rate_change;
  for (std::size_t k = 2; k <= kOrders; ++k)
    d[k] = force[k - 2] - damping * d[k - 1] - w2 * d[k - 2];

  const Real quick = mode.omega + damping;
  Real ahead = window_ > s ? Real(window_ - s) : Real(0);
  // The force keeps the bound growing; a step needs it only for the time scale of the mode.
  if (driven && reach == Reach::kStep && ahead * quick > 1) {
    ahead = 1 / quick;
    point.reach = std::min(point.reach, ahead);
  }
  const Bounds bound = special_bounds(mode, d, ahead);

  const auto order = static_cast<std::size_t>(m);
  const Real x = special.displacement, v = special.velocity;
  point.value +=
      m == 0 ? Real(x * change + v * rate_change) : Real(x * d[order] + v * d[order + 1]);
  point.slope += x * d[order + 1] + v * d[order + 2];
  point.bound += abs(x) * bound[order + 2] + abs(v) * bound[order + 3];
  point.curvature += order + 3 <= kOrders ? Real(x * d[order + 2] + v * d[order + 3]) : Real(0);
  point.third = order + 4 < bound.size()
                    ? Real(point.third + abs(x) * bound[order + 3] + abs(v) * bound[order + 4])
                    : std::numeric_limits<Real>::infinity();
  // Rounding is that of the energy at the start, not of the present one.
  const Real force_size = abs(mode.load) + (driven ? Real(abs(mode.force)) : Real(0));
  Real rounding = sqrt(special.qdot * special.qdot + w2 * special.q * special.q) + force_size * s +
                  (quick + frequency_) * special.apart;
  for (std::size_t k = 1; k < order; ++k) rounding *= quick;
  if (order >= 2) rounding += force_size;
  point.noise += kTermRoundings * std::numeric_limits<Real>::epsilon() * rounding *
                 (m == 0 ? Real(abs(x) * s + abs(v) * (quick * s))
                         : Real((abs(x) + abs(v) * quick) * (1 + s * quick)));
}

}  // namespace graze
