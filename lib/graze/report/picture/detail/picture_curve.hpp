// Curves over time and labels beside them, as pictures draw them.
#pragma once

#include <string>
#include <vector>

#include "graze/report/picture/picture_style.hpp"

namespace graze {

struct DrawnPoint {
  double time = 0.0;   // s
  double value = 0.0;  // SI; NaN: the curve breaks
};
using DrawnCurve = std::vector<DrawnPoint>;

// Past this many points a curve is drawn as the band between its extremes, one pair of them to
// every hair's breadth of the picture.
inline constexpr std::size_t kMostPoints = 12'000;

// Rows of time and value, each times its factor.
PlotTable table_of(const DrawnCurve& curve, double time_factor, double factor);

// What the values span; empty when none is finite.
AxisRange range_of(const DrawnCurve& curve);

// The largest absolute value in the range, 0 when it is empty.
double largest(const AxisRange& range);

struct CurveLabel {
  double at = 0.0;  // where on the vertical axis it belongs, in the axis' unit
  std::string text;
  std::string colour;
};

// Writes the labels beside the right end of the axes, each as near to its place as the others
// allow when none comes closer to another than `spacing` of the axis' height.
void label_curves(GnuplotScript& script, std::vector<CurveLabel> labels, const AxisRange& axis,
                  double spacing);

}  // namespace graze
