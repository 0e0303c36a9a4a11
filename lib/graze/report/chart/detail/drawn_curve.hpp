// Curves over time.
#pragma once

#include <vector>

#include "graze/report/chart/axis.hpp"

namespace graze {

struct DrawnPoint {
  double time = 0.0;   // s
  double value = 0.0;  // SI; NaN: the curve breaks
};
using DrawnCurve = std::vector<DrawnPoint>;

// The range of the values; empty when none is finite.
AxisRange range_of(const DrawnCurve& curve);

// The largest absolute value in the range, 0 when it is empty.
double largest(const AxisRange& range);

}  // namespace graze
