// A picture as a value: panels with axes, and on them curves, marks and fills, each with its look.
// Pictures (gnuplot) and pages (a browser) draw the same charts.
#pragma once

#include <array>
#include <map>
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
  bool is_asked = false;  // a range or a scale that is asked for holds for it, as for the first one
  std::string key = {};   // of the number of the chart's things that it shows; or none
};

struct ChartSeries {
  std::string title;  // in the legend, empty: none; equal titles make one entry
  Look look;
  bool is_line = true, has_marks = false;
  std::vector<double> x, y;        // SI; a NaN breaks a line
  std::vector<double> error = {};  // half the length of a bar at every point, SI; or none
  bool are_dots = false;           // marks by the million, the smallest that are seen
  std::vector<int> of = {};        // the thing that each point is of, -1: none; or none has one
  std::vector<int> which = {};     // of several values that the thing has; empty: always the first
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
  std::vector<int> ground;  // of every cell, -1: none
  // For a page, where every cell is the thing of its index: the values at their middles, what its
  // grounds tell together, and the key of the number that is shown in their place; or none.
  std::array<std::vector<double>, 2> middles = {};
  std::string name = {}, shown = {};
  std::vector<double> numbers = {};       // of every cell, SI, a NaN: none; or no cell has one
  ChartAxis bar = {};                     // of the numbers
  std::vector<std::string> colours = {};  // of the bar, at equal steps from its low end
};

// A filled part of the panel, from one value of x to a larger one over the whole height, or
// likewise of y; to the ends of the axes where they are infinite.
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

// What the points of a chart are of, as motions: what each is called, and numbers that it has. A
// page tells them of a point, and shows the first panel over any two of them.
struct ChartThings {
  struct Number {
    ChartAxis axis;                         // with its key
    bool is_single = true;                  // else a thing may have several
    bool is_axis = true;                    // else it is only told
    std::vector<double> values = {};        // thing by thing, SI, a NaN: none
    std::vector<std::size_t> first = {};    // of several: where those of each begin, and the end
    std::optional<double> level = {};       // a line across
    std::optional<double> turn = {};        // of an angle, after which it is the same
    std::vector<std::string> colours = {};  // of a bar, where cells are shown by it
    std::size_t rough = 0;                  // values from the front that are drawn, no more
  };
  struct Kind {
    std::string title;  // "branch 1, (1,1): stable"
    std::string of;     // what has the same is one line, whose things are near each other
    std::string name;   // within the panel: "(1,1)"; or none
  };
  std::vector<Kind> kinds = {};
  std::vector<int> kind = {};  // of each thing
  std::vector<Number> numbers = {};
  std::map<int, std::vector<std::pair<std::string, std::string>>> more = {};  // names and values
};

// Rows of panels, from the head down; panels one below the other over equal axes share their names.
struct Chart {
  std::string title;  // of a page: "Fit"
  std::vector<std::vector<ChartPanel>> rows;
  std::vector<std::string> legend = {};  // titles in their order; those not among them come first
  std::optional<ChartThings> things = {};
  // Other panels than the first of numbers that things have several of, or one of.
  std::vector<ChartPanel> layouts = {};
};

}  // namespace graze
