// The certified first descent of a curve through zero: the gap for contacts, its rate for extrema.
//
// From a point with value g >= 0 and slope g', and |second derivative| <= K from there on, the
// curve stays positive at least until the first root s of g + g' s - K s^2/2 = 0. Stepping by that
// s never passes the first zero and converges to it from the left; there is no step size to tune
// and nothing to miss. Once Newton's method is certain to converge to that same zero it
// finishes: Kantorovich asks 2 K |g| <= g'^2, here 4 K |g| <= g'^2, with steps that shrink sixfold.
//
// Near tangency double precision cannot always distinguish a touch from a miss; the result is then
// a touch, which means that the curve comes within its own rounding error of zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/stop_scope.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/flow/exact/detail/arc_curve.hpp"

namespace graze {

enum class ZeroKind {
  kNone,      // positive up to the end of the window
  kCrossing,  // a zero with negative slope
  kTouch,     // within rounding of zero, crossing undecided
  kBlocked,   // starts at zero with no way to leave: rest against a push
  kBudget,    // more evaluations than allowed, or it was asked to stop
  kNotFinite  // the curve left the range of the scalar
};

template <class Real>
struct FirstZero {
  ZeroKind kind = ZeroKind::kNone;
  Real s = 0;
  Real slope = 0;  // of the curve at s
  int evaluations = 0;
};

// The search is bounded: near-tangent motion at the noise floor takes a few thousand evaluations.
inline constexpr int kMostSearchEvaluations = 1000000;

// Evaluations between two looks at the stop signal: hardly any search takes so many, and with 400
// modes they take a tenth of a millisecond or so.
inline constexpr int kEvaluationsPerLook = 64;

namespace first_zero_detail {

// First positive root of value + slope s - bound s^2/2, written without squaring small numbers.
template <class Real>
Real safe_step(const Real& value, const Real& slope, const Real& bound) {
  using std::sqrt;
  if (bound == 0) {
    if (slope >= 0) return std::numeric_limits<Real>::infinity();
    return -value / slope;
  }
  if (slope == 0) return sqrt(2 * (value / bound));
  const Real root = sqrt(1 + 2 * (value / slope) * (bound / slope));
  return slope > 0 ? Real((slope / bound) * (1 + root)) : Real((value / -slope) * (2 / (1 + root)));
}

// How long value + slope s - bound s^2/2 stays positive; the bound may be negative.
template <class Real>
Real parabola_step(const Real& value, const Real& slope, const Real& bound) {
  using std::sqrt;
  // The fast way, where squares are far from the ends of the scalar's range.
  const Real square = slope * slope, whole = square + 2 * value * bound;
  if (square > std::numeric_limits<Real>::min() && whole < std::numeric_limits<Real>::max()) {
    if (!(whole >= 0)) return std::numeric_limits<Real>::infinity();
    const Real root = sqrt(whole);
    if (slope < 0) return 2 * value / (root - slope);
    return bound > 0 ? Real((slope + root) / bound) : std::numeric_limits<Real>::infinity();
  }
  if (!(bound < 0)) return safe_step(value, slope, bound);
  if (!(slope < 0)) return std::numeric_limits<Real>::infinity();
  const Real inside = 1 + 2 * (value / slope) * (bound / slope);
  if (!(inside >= 0)) return std::numeric_limits<Real>::infinity();
  return (value / -slope) * (2 / (1 + sqrt(inside)));
}

// The same with a bound on the third derivative, g >= g0 + g0' s + g0'' s^2/2 - third s^3/6: up to
// any h this is above a parabola with the bound third h/3 - g0''. Tries a few h, from `first` on,
// and returns the best.
template <class Real>
Real cubic_step(const Real& value, const Real& slope, const Real& curvature, const Real& third,
                const Real& first) {
  using std::sqrt;
  if (!(value > 0)) return 0;
  if (third == 0) return parabola_step(value, slope, Real(-curvature));
  const Real rise = third / 3;
  Real h = first, best = 0;
  // Every step is certain; at the longest one, step and h are equal.
  for (int i = 0; i < 3; ++i) {
    const Real step = parabola_step(value, slope, Real(rise * h - curvature));
    if (!(step >= 0)) return best;
    best = std::max(best, std::min(h, step));
    h = step < 7 * h ? Real((h + step) / 2) : Real(4 * h);
  }
  return best;
}

// How far the curve is certain to stay positive when its value at this point is `clear` > 0.
template <class Real>
Real clear_step(const CurvePoint<Real>& point, const Real& clear) {
  using std::isfinite;
  Real step = parabola_step(clear, point.slope, point.bound);
  if (!isfinite(step)) return std::min<Real>(step, point.reach);
  if (isfinite(point.slow.fall))
    step = std::max(step, cubic_step(Real(clear - point.slow.fall), point.slow.slope,
                                     point.slow.curvature, point.slow.third, Real(2 * step)));
  else if (isfinite(point.third))
    step = std::max(step,
                    cubic_step(clear, point.slope, point.curvature, point.third, Real(2 * step)));
  return std::min<Real>(step, point.reach);
}

// Bound on the second derivative within a distance of the point.
template <class Real>
Real bound_within(const CurvePoint<Real>& point, const Real& distance) {
  using std::abs;
  return std::min<Real>(point.bound, abs(point.curvature) + point.third * distance);
}

// Where the search for a descent through zero ends. For a crossing: the point from which Newton's
// method is certain to converge to it. Within twice its first step the curve then falls all the way
// and gets below minus half of where it started.
template <class Real>
struct Descent {
  FirstZero<Real> zero;
  CurvePoint<Real> point;  // at zero.s
};

// Halley's method inside the ball in which Newton's converges for certain: the step to the zero of
// the hyperbola that follows the curve to second order; stops when steps no longer shrink.
template <class Real, class Sample>
FirstZero<Real> finish(const Sample& sample, Real s, CurvePoint<Real> point, int evaluations) {
  using std::abs;
  const auto correction = [&] {
    const Real newton = -point.value / point.slope;
    return Real(newton / (1 + newton * point.curvature / (2 * point.slope)));
  };
  // From a distance d the next is C d^3. All points lie behind the first, whose bound holds there.
  // The remaining error always has the same sign, and a bias of half an ulp would show in the
  // energy (hard case E2), so a 32nd of that is required.
  const Real third = point.third;
  const auto is_exact = [&](const Real& step) {
    const Real bend = point.curvature / (2 * point.slope);
    const Real left = 2 * (third / (6 * abs(point.slope)) + bend * bend) * abs(step * step * step);
    return left <= std::numeric_limits<Real>::epsilon() / 64 * s;
  };
  Real step = correction();
  // 60 halvings exhaust any scalar in use; cubic convergence takes about three.
  for (int i = 0; i < 60; ++i) {
    const Real next = s + step > 0 ? Real(s + step) : Real(0);
    if (next == s) break;
    s = next;
    if (is_exact(step)) break;
    point = sample(s);
    ++evaluations;
    const Real shorter = correction();
    if (!(2 * abs(shorter) < abs(step))) break;
    step = shorter;
  }
  return {ZeroKind::kCrossing, s, point.slope, evaluations};
}

// How far a curve that starts at a zero of multiplicity n stays clear of it:
// g >= g_n s^n/n! - K_{n+1} s^{n+1}/(n+1)!. Negative where it cannot leave.
template <class Real>
Real departure_step(const ArcCurve<Real>& curve, int multiplicity) {
  const CurvePoint<Real> start = curve.at(Real(0), multiplicity - 1);
  if (!(start.slope > 0)) return -1;
  return start.bound > 0 ? Real((multiplicity + 1) * (start.slope / start.bound))
                         : std::numeric_limits<Real>::infinity();
}

template <class Real, class Sample>
Descent<Real> approach_descent(const Sample& sample, const Real& from, const Real& window,
                               const StopSignal& stop = {}) {
  using std::abs, std::isfinite;
  Real s = from;
  CurvePoint<Real> point;
  const auto ended = [&](ZeroKind kind, const Real& slope, int evaluations) {
    return Descent<Real>{{kind, s, slope, evaluations}, point};
  };
  for (int i = 1; i <= kMostSearchEvaluations; ++i) {
    if (!(s <= window)) {
      s = window;
      return ended(ZeroKind::kNone, Real(0), i);
    }
    if (StopScope::is_over() || (i % kEvaluationsPerLook == 0 && stop.requested()))
      return ended(ZeroKind::kBudget, Real(0), i);
    point = sample(s);
    if (!isfinite(point.value) || !isfinite(point.slope) || !isfinite(point.bound))
      return ended(ZeroKind::kNotFinite, Real(0), i);
    const Real ball = 2 * (abs(point.value) / -point.slope);
    if (point.slope < 0 && ball <= point.reach &&
        2 * (bound_within(point, ball) / -point.slope) * ball <= 1)
      return ended(ZeroKind::kCrossing, point.slope, i);
    const Real certain = std::max<Real>(point.value - point.noise, 0);
    if (certain == 0 && point.slope <= 0) return ended(ZeroKind::kTouch, point.slope, i);
    // Rising too slowly to leave the rounding: no contact can be resolved before the curve is down
    // to the far side of it.
    const bool lingers = certain == 0 && point.slope * point.slope < point.bound * point.noise;
    const Real clear = lingers ? std::max<Real>(point.value + point.noise, 0) : certain;
    const Real step = clear_step(point, clear);
    if (s + step == s) return ended(ZeroKind::kTouch, point.slope, i);
    s += step;
  }
  return ended(ZeroKind::kBudget, Real(0), kMostSearchEvaluations);
}

// The crossing itself, if it is within the window.
template <class Real, class Sample>
FirstZero<Real> finish_descent(const Sample& sample, const Descent<Real>& descent,
                               const Real& window) {
  if (descent.zero.kind != ZeroKind::kCrossing) return descent.zero;
  FirstZero<Real> zero = finish(sample, descent.zero.s, descent.point, descent.zero.evaluations);
  if (!(zero.s <= window)) return {ZeroKind::kNone, window, Real(0), zero.evaluations};
  return zero;
}

}  // namespace first_zero_detail

// First descent through zero, in (from, curve.window()], of the curve that `sample` gives.
template <class Real, class Sample>
FirstZero<Real> first_descent(const Sample& sample, const Real& from, const Real& window,
                              const StopSignal& stop = {}) {
  using namespace first_zero_detail;
  return finish_descent(sample, approach_descent(sample, from, window, stop), window);
}

// First contact in (0, curve.window()]. `multiplicity` > 0 means that the gap starts at a known
// zero: 1 just after an impact, 2 when pulled away from rest on the stop, 3 after a release, 4
// after a release at which the contact force vanishes without crossing zero. `sure`: the gap is
// known to be positive up to then.
template <class Real>
FirstZero<Real> first_contact(const ArcCurve<Real>& curve, int multiplicity, const Real& sure = 0,
                              const StopSignal& stop = {}) {
  Real from = sure;
  if (multiplicity > 0 && sure == 0) {
    from = first_zero_detail::departure_step(curve, multiplicity);
    if (from < 0) return {ZeroKind::kBlocked, Real(0), Real(0), 1};
  }
  return first_descent([&](const Real& s) { return curve.at(s, 0, Reach::kStep); }, from,
                       curve.window(), stop);
}

// The first instant at which a contact force falls through zero. The contact goes on where the
// force only comes within its rounding of zero and rises again. `sure`: the force is known to be
// positive up to then.
template <class Real>
FirstZero<Real> first_release(const ArcCurve<Real>& force, const StopSignal& stop = {},
                              const Real& sure = 0) {
  using std::sqrt;
  Real from = sure;
  int evaluations = 0;
  const auto sample = [&](const Real& s) { return force.at(s, 0, Reach::kStep); };
  while (evaluations < kMostSearchEvaluations) {
    FirstZero<Real> zero = first_descent(sample, from, force.window(), stop);
    evaluations += zero.evaluations;
    zero.evaluations = evaluations;
    if (zero.kind != ZeroKind::kCrossing && zero.kind != ZeroKind::kTouch) return zero;
    // A release is certain where the parabola through the point dips below the rounding.
    const CurvePoint<Real> point = force.at(zero.s, 0);
    if (point.slope < 0 && point.slope * point.slope > 8 * point.bound * point.noise) {
      zero.kind = ZeroKind::kCrossing;
      return zero;
    }
    if (point.bound == 0) return {ZeroKind::kNone, force.window(), Real(0), evaluations};
    // Skips the stretch in which rounding hides the sign, on either side of the lowest point.
    const Real beyond = zero.s + 4 * sqrt(2 * (point.noise / point.bound));
    if (!(beyond > zero.s)) return {ZeroKind::kBudget, zero.s, Real(0), evaluations};
    if (beyond <= force.window()) {
      const CurvePoint<Real> after = sample(beyond);
      if (after.value < -after.noise) {
        zero.kind = ZeroKind::kCrossing;
        return zero;
      }
    }
    from = beyond;
  }
  return {ZeroKind::kBudget, from, Real(0), evaluations};
}

}  // namespace graze
