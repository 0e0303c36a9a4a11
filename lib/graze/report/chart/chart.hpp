// A picture as a value: panels with axes, and on them curves, marks and fills, each with its look.
// Pictures (gnuplot) and pages (a browser) draw the same charts.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/axis.hpp"

namespace graze {

struct ChartAxis {
  std::string name = {};  // may use gnuplot's markup: "q_{1}"; \n begins a new line
  std::string unit = {};  // SI, "" for a pure number
  AxisRange range = {};   // of the values, SI; empty: of the drawn data
  AxisScale scale = AxisScale::kLinear;
  std::string path = {};   // of the parameter on the axis, "forcing.frequency"; or empty
  bool from_zero = false;  // zero belongs to the range
  bool is_asked = false;  // a requested range or scale applies to it, as to the first one
};

struct ChartSeries {
  std::string title;  // in the legend, empty: none; equal titles make one entry
  Look look;
  bool is_line = true, has_marks = false;
  std::vector<double> x, y;        // SI; a NaN breaks a line
  std::vector<double> error = {};  // half the length of a bar at every point, SI; or none
  bool are_dots = false;           // marks by the million, the smallest that are seen
};

// Words within a panel, written where there is room for them: beside a point, at one of several
// places on a curve, or over an area, there in several lines.
struct ChartName {
  enum class Of { kPoint, kCurve, kArea };
  Of of = Of::kPoint;
  std::string text;
  std::vector<std::pair<double, double>> places;  // SI
};

// Cells of a panel, row by row. A cell has a number, shown by a scale of colours beside the axes,
// or a ground, or neither.
struct ChartCells {
  struct Ground {
    std::string title, colour;
  };
  std::size_t columns = 0, rows = 0;
  // From the outer edge of the first column or row to that of the last, SI.
  std::array<double, 2> x{}, y{};
  std::vector<Ground> grounds;
  std::vector<int> ground;                // of every cell, -1: none
  std::vector<double> numbers = {};       // of every cell, SI, NaN for none; empty: no cell has one
  ChartAxis bar = {};                     // of the numbers
  std::vector<std::string> colours = {};  // of the bar, at equal steps from its low end
};

// A filled part of the panel, between two values of x over the whole height, or likewise of y;
// beyond the axes where infinite.
struct ChartFill {
  bool is_upright = false;  // across: between values of y
  double from = 0.0, to = 0.0;
  std::string title;
  std::string colour = kStopShade;
};

struct ChartPanel {
  ChartAxis x, y;
  std::vector<ChartSeries> series = {};
  std::vector<ChartFill> fills = {};
  std::vector<double> levels = {};  // lines across at these values of y
  std::string heading = {};         // above the axes
  double height = 2.6;              // cm of a picture 12 cm wide
  std::string remark = {};          // within the axes, where there is nothing to draw
  std::vector<ChartName> names = {};
  std::optional<ChartCells> cells = {};  // below all else
};

// Rows of panels, from the top; panels above each other over equal axes share their names.
struct Chart {
  std::string title;  // of a page: "Fit"
  std::vector<std::vector<ChartPanel>> rows;
  std::vector<std::string> legend = {};  // titles in their order; titles not listed come first
};

}  // namespace graze
