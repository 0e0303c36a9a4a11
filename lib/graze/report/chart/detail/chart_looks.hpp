// Series of charts by their looks, and how marks and dots shrink with their number.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "graze/report/chart/chart.hpp"

namespace graze {

inline ChartSeries marks_of(const Look& look) {
  return {.title = look.title, .look = look, .is_line = false, .has_marks = true, .x = {}, .y = {}};
}
inline ChartSeries dots_of(const Look& look) {
  ChartSeries series = marks_of(look);
  series.are_dots = true;
  return series;
}

inline void add_point(ChartSeries& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

// The relative size of this number of marks.
inline double crowded_mark_size(std::size_t count) {
  return 0.9 * std::clamp(std::sqrt(12.0 / std::max(static_cast<double>(count), 1.0)), 0.5, 1.0);
}
// The same for dots, at least `least`.
inline double crowded_dot_size(std::size_t count, double least) {
  return std::clamp(std::sqrt(4000.0 / std::max(static_cast<double>(count), 1.0)), least, 1.0);
}

}  // namespace graze
