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

// The smallest interior local minimum of the gap along the curve's window that is lower than
// `below`, or nothing when there is none: where the gap is sure to stay above that, or above the
// lowest minimum found, minima are passed over. Elsewhere extrema are found one after the other
// with the certified search, so none is passed over; where rounding cannot tell an inflection from
// a pair of extrema (both within the rounding of the gap of one another) it counts as none. A gap
// of minus infinity when the search cannot be finished, or was asked to stop (stop_scope.hpp).
//
// `multiplicity` n > 0 says that the gap departs from a known zero: 1 just after an impact, 2 when
// pulled away from rest on the stop, 3 after a release. It then rises at least until n g_n/K_(n+1),
// g_n the first derivative that does not vanish and K the bound on the next.
std::optional<GapMinimum> lowest_minimum(const ArcCurve<double>& curve, int multiplicity = 0,
                                         double below = std::numeric_limits<double>::infinity());

// All of them, in order; an unfinished search adds one of minus infinity.
std::vector<GapMinimum> minima_below(const ArcCurve<double>& curve, int multiplicity, double level);

// The gap of the lowest alone, m.
std::optional<double> smallest_minimum(const ArcCurve<double>& curve, int multiplicity = 0);

// Whether a motion is sure to tend to the steady response without meeting a stop again. With u its
// free part at the start of a forcing period,
//
//   |sum_j b_j P_j| + sum_j |b_j| sqrt(u_j^2 + u'_j^2/w_j^2) < gap - b.offset
//
// at every stop, because w^2 u^2 + u'^2 never grows. Needs forcing, and every mode stiff, damped
// and off resonance: elsewhere nothing is sure.
class LastingClearance {
 public:
  // `flow` is the system's.
  LastingClearance(const System& system, const ExactFlow<double>& flow);

  // Whether it is sure of the motion that starts from (q, q') at the start of a forcing period.
  bool is_sure(const Vector& q, const Vector& qdot) const;
  // The steady response at the start of a forcing period, where the motion then tends to.
  const State& steady() const { return steady_; }

 private:
  // What is left of the gap of a stop beside the steady response, m, and the size of the terms that
  // this is summed of.
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
