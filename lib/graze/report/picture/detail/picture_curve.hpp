// Curves over time and labels beside them, as pictures draw them.
#pragma once

#include <string>
#include <vector>

#include "graze/report/chart/detail/drawn_curve.hpp"
#include "graze/report/picture/picture_style.hpp"

namespace graze {

// Past this many points a curve is drawn as the band between its extremes, one pair of them to
// every hair's breadth of the picture.
inline constexpr std::size_t kMostPoints = 12'000;

// Rows of time and value, each times its factor.
PlotTable table_of(const DrawnCurve& curve, double time_factor, double factor);

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
