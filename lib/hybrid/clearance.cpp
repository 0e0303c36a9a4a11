#include "graze/hybrid/clearance.hpp"

#include <limits>

#include "graze/hybrid/first_zero.hpp"

namespace graze {
namespace {

// Whether the gap rises at s; where its rate is lost in rounding, its acceleration decides.
bool rises(const ArcCurve<double>& curve, double s) {
  const CurvePoint<double> rate = curve.at(s, 1);
  return std::abs(rate.value) > rate.noise ? rate.value > 0.0 : rate.slope > 0.0;
}

}  // namespace

std::optional<double> smallest_minimum(const ArcCurve<double>& curve, int multiplicity) {
  std::optional<double> smallest;
  double s = 0.0;
  bool rising = false;
  if (multiplicity > 0) {
    const CurvePoint<double> start = curve.at(0.0, multiplicity - 1);
    if (start.slope > 0.0) {
      if (start.bound == 0.0) return smallest;  // it rises for ever
      s = multiplicity * (start.slope / start.bound);
      rising = true;
    }
  }
  if (!rising) rising = rises(curve, s);
  int evaluations = 0;
  while (evaluations < kMostSearchEvaluations) {
    const FirstZero<double> extremum = first_extremum(curve, s, rising);
    evaluations += extremum.evaluations;
    if (extremum.kind == ZeroKind::kCrossing) {
      s = extremum.s;
      if (!rising) {
        const double gap = curve.at(s, 0).value;
        if (!smallest || gap < *smallest) smallest = gap;
      }
      rising = !rising;
    } else if (extremum.kind == ZeroKind::kTouch) {
      // An inflection within rounding: pass the width over which the rate stays in its rounding.
      const CurvePoint<double> point = curve.at(extremum.s, 1);
      if (point.bound == 0.0) return smallest;  // the gap does not change
      const double width = std::sqrt(2.0 * point.noise / point.bound);
      if (!(extremum.s + width > s)) break;
      s = extremum.s + width;
      rising = rises(curve, s);
    } else if (extremum.kind == ZeroKind::kNone) {
      return smallest;
    } else {
      break;
    }
  }
  // Nothing is known of the rest of the window, so nothing is promised of it.
  return -std::numeric_limits<double>::infinity();
}

}  // namespace graze
