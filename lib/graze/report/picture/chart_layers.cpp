#include "graze/report/picture/detail/chart_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include "graze/report/picture/detail/gnuplot_looks.hpp"
#include "graze/report/picture/detail/label_room.hpp"

namespace graze {
namespace {

// Number of shapes in a file of 1 MB. With more cells, drawn as an image, most are smaller than a
// hundredth of the panel.
constexpr std::size_t kMostShapes = 10'000;
constexpr double kLegendDot = 0.35;  // of gnuplot's points
constexpr double kSeam = 1.4;        // white beside curves that run over cells, points of width

bool rises(const std::vector<double>& values) {
  double last = -HUGE_VAL;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    if (value < last) return false;
    last = value;
  }
  return true;
}

// With more points than this a curve is drawn as the band between its extremes, one pair of them
// for every hair's breadth of the picture.
constexpr std::size_t kMostPoints = 12'000, kBands = 3'000;

PlotTable band_of(const ChartSeries& series, const ShownAxis& x, const ShownAxis& y) {
  PlotTable table;
  for (std::size_t band = 0; band < kBands; ++band) {
    const std::size_t end = (band + 1) * series.x.size() / kBands;
    std::optional<std::size_t> lowest, highest;
    for (std::size_t i = band * series.x.size() / kBands; i < end; ++i) {
      if (!std::isfinite(series.y[i])) continue;
      if (!lowest || series.y[i] < series.y[*lowest]) lowest = i;
      if (!highest || series.y[i] > series.y[*highest]) highest = i;
    }
    if (!lowest) {
      table.gap();
      continue;
    }
    const auto [first, second] = std::minmax(*lowest, *highest);
    for (const std::size_t i : {first, second}) table.row({x.of(series.x[i]), y.of(series.y[i])});
  }
  return table;
}

PlotTable table_of(const ChartSeries& series, const ShownAxis& x, const ShownAxis& y) {
  if (series.is_line && series.x.size() > kMostPoints && series.error.empty() && rises(series.x))
    return band_of(series, x, y);
  PlotTable table;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double across = x.of(series.x[i]), up = y.of(series.y[i]);
    if (series.error.empty())
      table.row({across, up});
    else
      table.row({across, up, y.factor() * series.error[i]});
  }
  return table;
}

// Named by its look if that has a name of its own in the panel.
std::string name_of(const PanelAxes& axes, std::size_t series) {
  const std::vector<ChartSeries>& all = axes.panel->series;
  std::string name = all[series].look.id;
  std::replace(name.begin(), name.end(), ' ', '_');
  const auto same = std::count_if(all.begin(), all.end(), [&](const ChartSeries& any) {
    return any.look.id == all[series].look.id;
  });
  return axes.prefix + (name.empty() || same > 1 ? fmt::format("series{}", series + 1) : name);
}

struct Rgb {
  double red = 255.0, green = 255.0, blue = 255.0;
};
Rgb rgb_of(const std::string& hex) {
  const long code = std::strtol(hex.c_str() + 1, nullptr, 16);
  return {static_cast<double>(code >> 16 & 255), static_cast<double>(code >> 8 & 255),
          static_cast<double>(code & 255)};
}

// The colour of a number on the bar; beyond its ends that of the end.
Rgb rgb_on(const ChartCells& cells, double number) {
  const AxisRange& range = cells.bar.range;
  const double place = std::clamp((number - range.low) / range.span(), 0.0, 1.0) *
                       static_cast<double>(cells.colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), cells.colours.size() - 2);
  const double part = place - static_cast<double>(below);
  const Rgb a = rgb_of(cells.colours[below]), b = rgb_of(cells.colours[below + 1]);
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
          a.blue + part * (b.blue - a.blue)};
}

// Equal adjacent cells of a row are one box, and equal boxes above each other, too.
struct CellBox {
  std::size_t first = 0, last = 0, row = 0, end = 0;  // columns, rows; the end is the row behind
  int ground = 0;
};
std::vector<CellBox> boxes_of(const ChartCells& cells) {
  std::vector<CellBox> list;
  for (std::size_t row = 0, above = 0; row < cells.rows; ++row) {
    const std::size_t begun = list.size();
    for (std::size_t first = 0; first < cells.columns;) {
      const auto ground = [&](std::size_t column) {
        return cells.ground[row * cells.columns + column];
      };
      std::size_t last = first;
      while (last + 1 < cells.columns && ground(last + 1) == ground(first)) ++last;
      const auto below = std::find_if(list.begin() + static_cast<std::ptrdiff_t>(above), list.end(),
                                      [&](const CellBox& box) {
                                        return box.end == row && box.first == first &&
                                               box.last == last && box.ground == ground(first);
                                      });
      if (ground(first) >= 0 && below != list.end())
        ++below->end;
      else if (ground(first) >= 0)
        list.push_back({first, last, row, row + 1, ground(first)});
      first = last + 1;
    }
    while (above < begun && list[above].end <= row) ++above;  // those that no row reaches any more
  }
  return list;
}

// The end of the first `of` columns or rows on the axis; .5 is half a cell.
double edge(const ShownAxis& axis, const std::array<double, 2>& ends, double of,
            std::size_t count) {
  return axis.of(ends[0] + (ends[1] - ends[0]) * of / static_cast<double>(count));
}

// An outline of the same colour covers the thin white gap that smoothed edges leave between two
// boxes.
std::vector<std::string> box_layers(const PanelAxes& axes, const std::vector<CellBox>& boxes,
                                    GnuplotScript& script) {
  const ChartCells& cells = *axes.panel->cells;
  std::map<int, PlotTable> tables;
  for (const CellBox& box : boxes) {
    const auto [left, right] =
        std::minmax({edge(axes.x, cells.x, static_cast<double>(box.first), cells.columns),
                     edge(axes.x, cells.x, static_cast<double>(box.last + 1), cells.columns)});
    const auto [low, high] =
        std::minmax({edge(axes.y, cells.y, static_cast<double>(box.row), cells.rows),
                     edge(axes.y, cells.y, static_cast<double>(box.end), cells.rows)});
    tables[box.ground].row({0.5 * (left + right), 0.5 * (low + high), left, right, low, high});
  }
  std::vector<std::string> layers;
  for (const auto& [ground, table] : tables) {
    const std::string name = fmt::format("{}cells{}", axes.prefix, ground + 1);
    script.data(name, table);
    layers.push_back(
        fmt::format("${0} with boxxyerror lc rgb '{1}' lw 0.3 fs solid border lc rgb '{1}' notitle",
                    name, cells.grounds[static_cast<std::size_t>(ground)].colour));
  }
  return layers;
}

// The bar beside the axes needs a layer with a palette: two dots without a size.
std::string bar_layer(const PanelAxes& axes, GnuplotScript& script) {
  const ChartCells& cells = *axes.panel->cells;
  const AxisRange& si = cells.bar.range;
  const AxisUnit unit = axis_unit(cells.bar.unit, std::max(std::abs(si.low), std::abs(si.high)));
  const AxisRange range{unit.factor * si.low, unit.factor * si.high};
  std::string palette;
  for (std::size_t i = 0; i < cells.colours.size(); ++i)
    palette += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, cells.colours[i]);
  script.command("set palette defined (" + palette + ")");
  script.command("set cbrange " + range.text());
  script.command(fmt::format("set cbtics {:.6g}", range.tic_step(6)));
  script.command("set label " + axis_label(cells.bar.name, unit.unit) +
                 " at screen 1-0.018*across, graph 0.5 center rotate");
  PlotTable ends;
  ends.row({axes.x.range().low, axes.y.range().low, range.low});
  ends.row({axes.x.range().high, axes.y.range().high, range.high});
  script.data(axes.prefix + "ends", ends);
  return "$" + axes.prefix + "ends using 1:2:3 with points pt 7 ps 0 lc palette notitle";
}

// Browsers smooth an image, which would mix the colours of large cells.
std::string image_layer(const PanelAxes& axes, bool is_svg, GnuplotScript& script) {
  const ChartCells& cells = *axes.panel->cells;
  PlotTable table;
  for (std::size_t i = 0; i < cells.ground.size(); ++i) {
    const bool has_number = !cells.numbers.empty() && std::isfinite(cells.numbers[i]);
    const Rgb rgb = has_number ? rgb_on(cells, cells.numbers[i])
                    : cells.ground[i] >= 0
                        ? rgb_of(cells.grounds[static_cast<std::size_t>(cells.ground[i])].colour)
                        : Rgb{};
    const auto column = static_cast<double>(i % cells.columns),
               row = static_cast<double>(i / cells.columns);
    table.row({edge(axes.x, cells.x, column + 0.5, cells.columns),
               edge(axes.y, cells.y, row + 0.5, cells.rows), std::round(rgb.red),
               std::round(rgb.green), std::round(rgb.blue)});
  }
  script.data(axes.prefix + "cells", table);
  return fmt::format("${}cells using 1:2:3:4:5 with rgbimage {}notitle", axes.prefix,
                     is_svg && cells.ground.size() <= kMostShapes ? "pixels " : "");
}

}  // namespace

bool PanelAxes::has_dots() const {
  return std::any_of(panel->series.begin(), panel->series.end(),
                     [](const ChartSeries& series) { return series.are_dots; });
}

std::string layer_of(const ChartSeries& series) {
  const Look& look = series.look;
  if (series.is_line && series.has_marks)
    return fmt::format("with linespoints lw {:.3g}{} pt {} ps {:.2f}*mark lc rgb '{}'", look.width,
                       dashes_of(look), point_type(look), look.size, look.colour);
  if (series.is_line) return line_of(look);
  if (!series.error.empty())
    return fmt::format("using 1:2:3 with yerrorbars pt {} ps {:.2f}*mark lw 0.7 lc rgb '{}'",
                       point_type(look), look.size, look.colour);
  return mark_of(look);
}

std::string legend_entry(const ChartSeries& series) {
  const std::string how = series.are_dots
                              ? fmt::format("with points pt {} ps {:.3g} lc rgb '{}'",
                                            point_type(series.look), kLegendDot, series.look.colour)
                              : layer_of(series);
  return "NaN " + how + " title " + gnuplot_string(series.title);
}

// A white ground has an outline.
std::string legend_entry(const ChartCells::Ground& ground) {
  return fmt::format("NaN with boxes lc rgb '{}' lw 0.5 fs solid border lc rgb '{}' title {}",
                     ground.colour, kGrey, gnuplot_string(ground.title));
}

std::vector<std::string> cell_layers(const PanelAxes& axes, bool is_svg, GnuplotScript& script) {
  if (!axes.panel->cells) return {};
  const ChartCells& cells = *axes.panel->cells;
  if (cells.numbers.empty()) {
    const std::vector<CellBox> boxes = boxes_of(cells);
    if (boxes.size() <= kMostShapes) return box_layers(axes, boxes, script);
  }
  std::vector<std::string> layers = {image_layer(axes, is_svg, script)};
  if (!cells.numbers.empty()) layers.push_back(bar_layer(axes, script));
  return layers;
}

std::vector<std::string> curve_layers(const PanelAxes& axes, GnuplotScript& script) {
  std::vector<std::string> layers;
  for (std::size_t i = 0; i < axes.panel->series.size(); ++i) {
    const ChartSeries& series = axes.panel->series[i];
    if (series.are_dots) continue;
    const std::string name = name_of(axes, i);
    script.data(name, table_of(series, axes.x, axes.y));
    if (axes.panel->cells && series.is_line)
      layers.push_back(fmt::format("${} with lines lw {:.3g} dt solid lc rgb '#FFFFFF'", name,
                                   series.look.width + kSeam));
    if (series.is_line || !series.error.empty())
      layers.push_back("$" + name + " " + layer_of(series));
    else
      add_marks(layers, "$" + name, series.look);
  }
  return layers;
}

std::vector<std::string> dot_layers(const PanelAxes& axes, double size, GnuplotScript& script) {
  std::vector<std::string> layers;
  for (std::size_t i = 0; i < axes.panel->series.size(); ++i) {
    const ChartSeries& series = axes.panel->series[i];
    if (!series.are_dots) continue;
    script.data(name_of(axes, i), table_of(series, axes.x, axes.y));
    layers.push_back(fmt::format("${} with points pt {} ps {:.3g} lc rgb '{}'", name_of(axes, i),
                                 point_type(series.look), size * series.look.size / kLegendDot,
                                 series.look.colour));
  }
  return layers;
}

void write_names(const PanelAxes& axes, double width, double height, LabelChoice choice,
                 GnuplotScript& script) {
  const ChartPanel& panel = *axes.panel;
  if (panel.names.empty()) return;
  LabelRoom room({axes.x.range(), axes.y.range(), axes.x.is_log(), axes.y.is_log()}, width, height);
  for (const ChartSeries& series : panel.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const double x = axes.x.of(series.x[i]), y = axes.y.of(series.y[i]);
      if (series.are_dots) room.add_dot(x, y);
      if (!series.is_line && !series.are_dots) room.add_mark(x, y);
      if (series.is_line && i > 0)
        room.add_line(axes.x.of(series.x[i - 1]), axes.y.of(series.y[i - 1]), x, y);
    }
  const auto shown = [&](const std::pair<double, double>& place) {
    return std::pair(axes.x.of(place.first), axes.y.of(place.second));
  };
  std::vector<LabelRoom::NamedPoint> points;
  for (const ChartName& name : panel.names) {
    if (name.of == ChartName::Of::kCurve) continue;
    const auto [x, y] = shown(name.places.front());
    if (name.of == ChartName::Of::kArea)
      room.write_over(script, name.text, x, y);
    else
      points.push_back({x, y, name.text});
  }
  if (choice == LabelChoice::kNone) return;
  if (panel.cells) room.stand_on_white();
  room.name(script, points);
  if (choice != LabelChoice::kAll) return;
  for (const ChartName& name : panel.names) {
    if (name.of != ChartName::Of::kCurve) continue;
    std::vector<std::pair<double, double>> places;
    for (const auto& place : name.places) places.push_back(shown(place));
    room.write(script, name.text, places);
  }
}

}  // namespace graze
