#include "graze/report/chart/detail/drawn_curve.hpp"

#include <algorithm>
#include <cmath>

namespace graze {

AxisRange range_of(const DrawnCurve& curve) {
  AxisRange range;
  for (const DrawnPoint& point : curve) range.include(point.value);
  return range;
}

double largest(const AxisRange& range) {
  return range.empty() ? 0.0 : std::max(std::abs(range.low), std::abs(range.high));
}

}  // namespace graze
