// The contents of a panel of a chart, as gnuplot's layers over axes.
#pragma once

#include <string>
#include <vector>

#include "graze/report/chart/chart.hpp"
#include "graze/report/picture/detail/picture_style.hpp"

namespace graze {

// A panel with its axes, and the prefix that distinguishes the names of its data from those of
// other panels: "panel2_".
struct PanelAxes {
  const ChartPanel* panel;
  ShownAxis x, y;
  std::string prefix;

  bool has_dots() const;
};
// The panels of a chart, row by row, with the axes of the request.
std::vector<PanelAxes> axes_of(const Chart& chart, const PictureRequest& request);
// Whether two axes show the same quantity, possibly over different ranges.
bool is_alike(const ChartAxis& a, const ChartAxis& b);

// How a series is drawn, without its data: "with lines lw 1.8 ..".
std::string layer_of(const ChartSeries& series);
// The same for a legend, with its title.
std::string legend_entry(const ChartSeries& series);
std::string legend_entry(const ChartCells::Ground& ground);

// Each writes its data and returns layers. `is_svg`: cells may be shapes.
std::vector<std::string> cell_layers(const PanelAxes& axes, bool is_svg, GnuplotScript& script);
std::vector<std::string> curve_layers(const PanelAxes& axes, GnuplotScript& script);
// Dots of this size, in gnuplot's points.
std::vector<std::string> dot_layers(const PanelAxes& axes, double size, GnuplotScript& script);

// Writes the names of the panel of this width and height (cm), if they are wanted.
void write_names(const PanelAxes& axes, double width, double height, LabelChoice choice,
                 GnuplotScript& script);

}  // namespace graze
