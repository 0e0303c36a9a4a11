// Cells of a plane of two numbers in charts.
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
  kUnbounded  // likewise, but as far below zero as above: negative values may have no bound
};

// Numbers as colours: the range that five colours cover.
struct CellBar {
  AxisRange range;
  std::array<const char*, 5> colours;
};
// The bar for the values of the cells; values that are not finite are left out.
CellBar cell_bar(std::size_t cells, const std::function<double(std::size_t cell)>& of,
                 CellScale scale);

// The range of the cells along an axis, SI: half a cell beyond the values at their middles.
AxisRange cell_range(const PlaneAxis& axis);

// The shown quantity of every cell.
struct CellNumbers {
  std::function<double(std::size_t cell)> of;  // SI, not finite: none
  // Why a cell has none: "clear of the stops", "not run", ..; one ground and entry of the legend
  // each.
  std::function<std::string(std::size_t cell)> without;
  std::string title, unit;  // of the bar beside the axes, SI
  CellScale scale = CellScale::kFromZero;
  std::string key = {};  // of what a page may show
};

// A panel of cells that have no ground yet.
ChartPanel cells_panel(const Plane& plane, const std::string& x_unit, const std::string& y_unit);
void set_numbers(const CellNumbers& numbers, ChartCells& cells);

}  // namespace graze
