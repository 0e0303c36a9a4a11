// Definitions of gap_curve.hpp; included by one translation unit per scalar.
#pragma once

#include <limits>

#include "graze/flow/exact_flow_impl.hpp"
#include "graze/flow/gap_curve.hpp"
#include "graze/system/gap_value.hpp"

namespace graze {
namespace gap_curve_detail {

// Rounding of one term c (e^{l s} - 1): the argument, sine, exponential, two products and the sum
// add at most about one eps each of |c| |l| s.
inline constexpr int kRoundings = 8;

}  // namespace gap_curve_detail

template <class Real>
GapCurve<Real>::GapCurve(const Arc<Real>& arc, const RealVector<Real>& row, const Real& gap,
                         const Real& window, bool on_stop)
    : frequency_(arc.flow().frequency()), theta_(arc.start_phase()), window_(window) {
  using std::abs, std::cos, std::sin;
  const ExactFlow<Real>& flow = arc.flow();
  PlanarNumber<Real> harmonic;
  exponentials_.reserve(static_cast<std::size_t>(2 * flow.modes() + 1));
  for (int j = 0; j < flow.modes(); ++j) {
    const ModeFlow<Real>& mode = flow.mode(j);
    const PlanarNumber<Real>& a = arc.amplitude(j);
    harmonic.re += row[j] * mode.forced.re;
    harmonic.im += row[j] * mode.forced.im;
    // The free part is the state less the forced response: it carries the rounding of the latter.
    const Real forced = abs(mode.forced.re) + abs(mode.forced.im);
    if (mode.kind == ModeKind::kOscillatory || mode.kind == ModeKind::kOverdamped) {
      const Real formed_from = abs(row[j]) * forced * (1 + frequency_ / mode.second);
      if (mode.kind == ModeKind::kOscillatory) {
        add_exponential({row[j] * a.re, row[j] * a.im}, mode.first, mode.second, formed_from);
      } else {
        add_exponential({row[j] * a.re, 0}, mode.first, 0, formed_from);
        add_exponential({row[j] * a.im, 0}, mode.second, 0, formed_from);
      }
    } else {
      specials_.push_back({&mode, row[j], a.re, a.im, forced});
    }
  }
  if (flow.forced())
    add_exponential(
        exact_flow_detail::times(harmonic, PlanarNumber<Real>{cos(theta_), sin(theta_)}), 0,
        frequency_, 0);
  if (!on_stop) {
    const GapValue<Real> start = gap_value(row, arc.start_displacements(), gap);
    start_value_ = start.value;
    start_noise_ = start.rounding;
  }
}

template <class Real>
void GapCurve<Real>::add_exponential(const PlanarNumber<Real>& c, const Real& decay,
                                     const Real& frequency, const Real& formed_from) {
  using std::abs, std::sqrt;
  Exponential term;
  term.decay = decay;
  term.frequency = frequency;
  const PlanarNumber<Real> rate{-decay, frequency};
  const Real rate_size = sqrt(decay * decay + frequency * frequency);
  term.coefficient[0] = c;
  // Where the square of |c| leaves the range of the scalar, the sum of its parts bounds it.
  const Real square = c.re * c.re + c.im * c.im;
  const bool in_range =
      square > std::numeric_limits<Real>::min() && square < std::numeric_limits<Real>::max();
  term.size[0] = in_range ? Real(sqrt(square)) : Real(abs(c.re) + abs(c.im));
  for (std::size_t m = 1; m < 4; ++m)
    term.coefficient[m] = exact_flow_detail::times(term.coefficient[m - 1], rate);
  for (std::size_t m = 1; m < 5; ++m) term.size[m] = term.size[m - 1] * rate_size;
  term.rounded[0] = term.size[0] + formed_from;
  for (std::size_t m = 1; m < 5; ++m) term.rounded[m] = term.rounded[m - 1] * rate_size;
  exponentials_.push_back(term);
}

template <class Real>
CurvePoint<Real> GapCurve<Real>::at(const Real& s, int m) const {
  using std::cos, std::expm1, std::sin;
  const auto order = static_cast<std::size_t>(m);
  CurvePoint<Real> point;
  Real rounding = 0;
  for (const Exponential& term : exponentials_) {
    const Real decay_minus_one = term.decay == 0 ? Real(0) : Real(expm1(-term.decay * s));
    const Real decay = 1 + decay_minus_one;
    const Real half = term.frequency * s / 2;
    const Real sine = sin(half), cosine = cos(half);
    const Real re_minus_one = decay_minus_one - decay * 2 * sine * sine;
    const Real re = 1 + re_minus_one, im = decay * 2 * sine * cosine;
    const PlanarNumber<Real>& c = term.coefficient[order];
    const PlanarNumber<Real>& next = term.coefficient[order + 1];
    point.value -= c.re * (m == 0 ? re_minus_one : re) - c.im * im;
    point.slope -= next.re * re - next.im * im;
    point.bound += decay * term.size[order + 2];
    rounding += decay * (m == 0 ? Real(0) : term.rounded[order]) + s * term.rounded[order + 1];
  }
  point.noise = gap_curve_detail::kRoundings * std::numeric_limits<Real>::epsilon() * rounding;
  for (const Special& special : specials_) add_special(special, s, m, point);
  if (m == 0) {
    point.value += start_value_;
    point.noise += start_noise_;
  }
  return point;
}

template <class Real>
void GapCurve<Real>::add_special(const Special& special, const Real& s, int m,
                                 CurvePoint<Real>& point) const {
  using std::abs, std::cos, std::sqrt;
  const ModeFlow<Real>& mode = *special.mode;
  const Real w2 = mode.omega * mode.omega;
  const FreeBasis<Real> basis = free_basis(mode.delta, mode.discriminant, s);
  // Displacement since the start, velocity, and from the equation of motion the next derivatives.
  Real change =
      special.q * (basis.cosine_minus_one + mode.delta * basis.sine) + special.qdot * basis.sine;
  std::array<Real, 4> derivative;
  derivative[1] =
      special.qdot * (basis.cosine - mode.delta * basis.sine) - special.q * w2 * basis.sine;
  Real force = 0, force_rate = 0, force_size = 0;
  if (mode.kind == ModeKind::kResonant) {
    using std::sin;
    const PlanarNumber<Real> x = resonant_response(mode, frequency_, theta_, s);
    change += mode.force * x.re;
    derivative[1] += mode.force * x.im;
    force = mode.force * cos(theta_ + frequency_ * s);
    force_rate = -mode.force * frequency_ * sin(theta_ + frequency_ * s);
    force_size = abs(mode.force);
  }
  derivative[0] = special.q + change;
  derivative[2] = force - 2 * mode.delta * derivative[1] - w2 * derivative[0];
  derivative[3] = force_rate - 2 * mode.delta * derivative[2] - w2 * derivative[1];

  // sqrt(q'^2 + w^2 q^2) of the free motion never grows; the force adds at most |f| per time.
  const Real energy = sqrt(derivative[1] * derivative[1] + w2 * derivative[0] * derivative[0]) +
                      force_size * (window_ > s ? Real(window_ - s) : Real(0));
  std::array<Real, 5> bound;
  bound[1] = energy;
  bound[2] = (mode.omega + 2 * mode.delta) * energy + force_size;
  bound[3] = 2 * mode.delta * bound[2] + w2 * bound[1] + force_size * frequency_;
  bound[4] = 2 * mode.delta * bound[3] + w2 * bound[2] + force_size * frequency_ * frequency_;

  const auto order = static_cast<std::size_t>(m);
  point.value -= special.row * (m == 0 ? change : derivative[order]);
  point.slope -= special.row * derivative[order + 1];
  point.bound += abs(special.row) * bound[order + 2];
  // The start's energy, not the present one, has gone through the roundings.
  const Real start = sqrt(special.qdot * special.qdot + w2 * special.q * special.q) +
                     2 * mode.delta * abs(special.q) + force_size * s +
                     (mode.omega + 2 * mode.delta + frequency_) * special.forced;
  Real rounding = start;
  for (std::size_t k = 1; k < order; ++k) rounding *= mode.omega + 2 * mode.delta;
  point.noise += gap_curve_detail::kRoundings * std::numeric_limits<Real>::epsilon() *
                 abs(special.row) * rounding *
                 (m == 0 ? s : Real(1 + s * (mode.omega + 2 * mode.delta)));
}

template <class Real>
Real GapCurve<Real>::start_derivative(int m) const {
  return m == 0 ? start_value_ : (m == 3 ? at(Real(0), 2).slope : at(Real(0), m).value);
}

template <class Real>
Real GapCurve<Real>::start_bound(int m) const {
  return at(Real(0), m - 2).bound;
}

}  // namespace graze
