// How near the motion comes to a stop between contacts.
#pragma once

#include <optional>

#include "graze/flow/arc_curve.hpp"

namespace graze {

struct GapMinimum {
  double s = 0.0;    // on the curve's clock
  double gap = 0.0;  // m
};

// The smallest interior local minimum of the gap along the curve's window, or nothing when there is
// none. Extrema are found one after the other with the certified search, so none is passed over;
// where rounding cannot tell an inflection from a pair of extrema (both within the rounding of the
// gap of one another) it counts as none. A gap of minus infinity when the search cannot be
// finished.
std::optional<GapMinimum> lowest_minimum(const ArcCurve<double>& curve);

// Its gap alone, m.
std::optional<double> smallest_minimum(const ArcCurve<double>& curve);

}  // namespace graze
