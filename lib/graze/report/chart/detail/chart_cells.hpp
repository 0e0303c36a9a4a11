// Cells of a plane of two numbers as charts show them.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "graze/report/chart/chart.hpp"
#include "graze/study/plane/plane.hpp"

namespace graze {

enum class CellScale {
  kAsIs,      // from dark to bright
  kFromZero,  // the same with zero among them
  kSigned,    // away from zero in two hues
  kUnbounded  // likewise, only as far below zero as above: smaller ones may have no bound
};

// Numbers as colours: what a range spans, from one end of five colours to the other.
struct CellBar {
  AxisRange range;
  std::array<const char*, 5> colours;
};
// Of so many cells; what is not finite is left out.
CellBar cell_bar(std::size_t cells, const std::function<double(std::size_t cell)>& of,
                 CellScale scale);

// What the cells of an axis span, SI: they reach half their width beyond the values at their
// middles.
AxisRange cell_range(const PlaneAxis& axis);

// What is shown of every cell.
struct CellNumbers {
  std::function<double(std::size_t cell)> of;  // SI, not finite: none
  // Why it has none: "clear of the stops", "not run", ..; one ground each, and the legend says so.
  std::function<std::string(std::size_t cell)> without;
  std::string title, unit;  // of the bar beside the axes, SI
  CellScale scale = CellScale::kFromZero;
  std::string key = {};  // of what a page may show
};

// A panel of cells that have no ground yet.
ChartPanel cells_panel(const Plane& plane, const std::string& x_unit, const std::string& y_unit);
void set_numbers(const CellNumbers& numbers, ChartCells& cells);

}  // namespace graze
