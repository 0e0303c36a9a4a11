// A derivative of a curve at one s: what a certified search needs.
#pragma once

#include <limits>

namespace graze {

template <class Real>
struct CurvePoint {
  Real value = 0;                                      // derivative m of the curve
  Real slope = 0;                                      // derivative m + 1
  Real bound = 0;                                      // |derivative m + 2| from s over `reach`
  Real noise = 0;                                      // rounding error of value
  Real reach = std::numeric_limits<Real>::infinity();  // s; infinite: to the end of the window
  Real curvature = 0;                                  // derivative m + 2
  Real third = std::numeric_limits<Real>::infinity();  // |derivative m + 3|, bounded like `bound`
  // The same for the slow terms alone. The fast ones together fall by at most `fall` from here on;
  // infinite where slow and fast terms are not separated.
  struct Slow {
    Real slope = 0, curvature = 0, third = 0;
    Real fall = std::numeric_limits<Real>::infinity();
  };
  Slow slow{};

  // Becomes the point of the negative curve.
  void turn_round() {
    value = -value;
    slope = -slope;
    curvature = -curvature;
    slow = {};
  }
};

// How far a bound has to hold: to the end of the window, or only as far as the next step of a
// search needs it, where that makes the step longer.
enum class Reach { kWindow, kStep };

}  // namespace graze
