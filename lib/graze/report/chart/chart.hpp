// A picture as a value: panels with axes, and on them curves, marks and fills, each with the look
// of what it stands for. Pictures (gnuplot) and pages (a browser) draw the same charts.
#pragma once

#include <string>
#include <vector>

#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/axis.hpp"

namespace graze {

struct ChartAxis {
  std::string name = {};  // may use gnuplot's markup: "q_{1}"; \n begins a new line
  std::string unit = {};  // SI, "" for a pure number
  AxisRange range = {};   // of the values, SI; empty: of what is drawn
  AxisScale scale = AxisScale::kLinear;
  std::string path = {};   // of the parameter that it is, "forcing.frequency"; or none
  bool from_zero = false;  // zero belongs to the range
};

struct ChartSeries {
  std::string title;  // of the legend, empty: none there; what has one title is one entry
  Look look;
  bool is_line = true, has_marks = false;
  std::vector<double> x, y;        // SI; a NaN breaks a line
  std::vector<double> error = {};  // half the length of a bar at every point, SI; or none
};

// A filled part of the panel, from one value of x to another over the whole height, or likewise of
// y; beyond the axes where infinite.
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
};

// Rows of panels, from the head down; panels one below the other over equal axes share their names.
struct Chart {
  std::string title;  // of a page: "Fit"
  std::vector<std::vector<ChartPanel>> rows;
};

}  // namespace graze
