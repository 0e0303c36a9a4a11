// How near the motion comes to a stop between contacts, and whether it ever will.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"

namespace graze {

struct GapMinimum {
  double s = 0.0;    // on the curve's clock
  double gap = 0.0;  // m
};

// Returns the smallest interior local minimum of the gap along the curve's window that is lower
// than `below`, or nullopt when there is none. Where the gap is certain to stay above `below`, or
// above the lowest minimum found, minima are skipped. Elsewhere extrema are found one after the
// other with the certified search, so none is missed; where an inflection and a pair of extrema
// differ by less than the rounding of the gap, it counts as an inflection. The gap is minus
// infinity when the search cannot be finished, or was asked to stop (stop_scope.hpp).
//
// `multiplicity` n > 0 means that the gap departs from a known zero: 1 just after an impact, 2 when
// pulled away from rest on the stop, 3 after a release. It then rises at least until n g_n/K_(n+1),
// g_n the first derivative that does not vanish and K the bound on the next.
std::optional<GapMinimum> lowest_minimum(const ArcCurve<double>& curve, int multiplicity = 0,
                                         double below = std::numeric_limits<double>::infinity());

// All such minima, in order; an unfinished search adds one of minus infinity.
std::vector<GapMinimum> minima_below(const ArcCurve<double>& curve, int multiplicity, double level);

// The gap of the lowest minimum alone, m.
std::optional<double> smallest_minimum(const ArcCurve<double>& curve, int multiplicity = 0);

// Whether a motion is certain to tend to the steady response without meeting a stop again. With u
// its free part at the start of a forcing period, the condition is
//
//   |sum_j b_j P_j| + sum_j |b_j| sqrt(u_j^2 + u'_j^2/w_j^2) < gap - b.offset
//
// at every stop, because w^2 u^2 + u'^2 never grows. Needs forcing, and every mode stiff, damped
// by itself and off resonance; otherwise the answer is always "not certain".
class LastingClearance {
 public:
  // `flow` is the system's.
  LastingClearance(const System& system, const ExactFlow<double>& flow);

  // Whether this is certain for the motion that starts from (q, q') at the start of a forcing
  // period.
  bool is_sure(const Vector& q, const Vector& qdot) const;
  // The steady response at the start of a forcing period, where the motion then tends to.
  const State& steady() const { return steady_; }

 private:
  // The distance of a stop from the steady response, m, and the size of the terms of this sum.
  struct Room {
    Vector weights;  // |b_j|
    double left = 0.0, size = 0.0;
  };
  std::vector<Room> rooms_;
  Vector omega_;  // rad/s
  State steady_;
  bool may_be_ = false;  // all that it needs is there
};

}  // namespace graze
