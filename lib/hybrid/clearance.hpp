// How near the motion comes to a stop between contacts.
#pragma once

#include <optional>

#include "graze/flow/arc_curve.hpp"

namespace graze {

// The smallest interior local minimum of the gap along the curve's window, m, or nothing when there
// is none. Extrema are found one after the other with the certified search, so none is passed over;
// where rounding cannot tell an inflection from a pair of extrema (both within the rounding of the
// gap of one another) it counts as none. Minus infinity when the search cannot be finished.
//
// `multiplicity` n > 0 says that the gap departs from a known zero: 1 just after an impact, 2 when
// pulled away from rest on the stop, 3 after a release. It then rises at least until n g_n/K_(n+1),
// g_n the first derivative that does not vanish and K the bound on the next.
std::optional<double> smallest_minimum(const ArcCurve<double>& curve, int multiplicity = 0);

}  // namespace graze
