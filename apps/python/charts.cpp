#include "charts.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>

namespace graze {
namespace {

namespace py = pybind11;

py::array numbers(const std::vector<double>& list) {
  return py::array_t<double>(static_cast<py::ssize_t>(list.size()), list.data());
}

const char* mark_name(MarkShape mark) {
  switch (mark) {
    case MarkShape::kDot:
      return ".";
    case MarkShape::kCircle:
      return "o";
    case MarkShape::kSquare:
      return "s";
    case MarkShape::kDiamond:
      return "D";
    case MarkShape::kUp:
      return "^";
    case MarkShape::kDown:
      return "v";
    case MarkShape::kPentagon:
      return "p";
    case MarkShape::kCross:
      return "x";
    case MarkShape::kPlus:
      return "+";
    case MarkShape::kStar:
      return "$*$";
    case MarkShape::kNone:
      break;
  }
  return "";
}

py::dict look_dict(const Look& look) {
  using namespace py::literals;
  return py::dict("id"_a = look.id, "title"_a = plain_text(look.title), "colour"_a = look.colour,
                  "dashes"_a = look.dashes, "width"_a = look.width, "mark"_a = mark_name(look.mark),
                  "open"_a = look.open, "size"_a = look.size);
}

double largest_of(const ChartPanel& panel, bool upright) {
  double largest = 0.0;
  for (const ChartSeries& series : panel.series)
    for (const double value : upright ? series.y : series.x)
      if (std::isfinite(value)) largest = std::fmax(largest, std::abs(value));
  const AxisRange& range = upright ? panel.y.range : panel.x.range;
  return range.empty() ? largest : std::fmax(std::abs(range.low), std::abs(range.high));
}

py::dict axis_dict(const ChartAxis& axis, double largest) {
  using namespace py::literals;
  // Decades are read as they are.
  const AxisUnit unit =
      axis.scale == AxisScale::kLinear ? axis_unit(axis.unit, largest) : AxisUnit{1.0, axis.unit};
  const py::object range = axis.range.empty()
                               ? py::object(py::none())
                               : py::object(py::make_tuple(axis.range.low, axis.range.high));
  return py::dict("name"_a = plain_text(axis.name), "unit"_a = plain_text(unit.unit),
                  "factor"_a = unit.factor, "range"_a = range, "scale"_a = name_of(axis.scale),
                  "from_zero"_a = axis.from_zero);
}

py::dict cells_dict(const ChartCells& cells) {
  using namespace py::literals;
  py::list grounds;
  for (const ChartCells::Ground& ground : cells.grounds)
    grounds.append(py::make_tuple(plain_text(ground.title), ground.colour));
  const AxisRange& bar = cells.bar.range;
  return py::dict("columns"_a = cells.columns, "rows"_a = cells.rows, "x"_a = cells.x,
                  "y"_a = cells.y, "grounds"_a = grounds,
                  "ground"_a = py::array_t<int>(static_cast<py::ssize_t>(cells.ground.size()),
                                                cells.ground.data()),
                  "numbers"_a = numbers(cells.numbers), "colours"_a = cells.colours,
                  "bar"_a = axis_dict(cells.bar, std::fmax(std::abs(bar.low), std::abs(bar.high))));
}

py::dict panel_dict(const ChartPanel& panel) {
  using namespace py::literals;
  py::list series, fills;
  for (const ChartSeries& one : panel.series)
    series.append(py::dict("title"_a = plain_text(one.title), "look"_a = look_dict(one.look),
                           "is_line"_a = one.is_line, "has_marks"_a = one.has_marks,
                           "x"_a = numbers(one.x), "y"_a = numbers(one.y),
                           "error"_a = numbers(one.error)));
  for (const ChartFill& fill : panel.fills)
    fills.append(py::dict("is_upright"_a = fill.is_upright, "from"_a = fill.from, "to"_a = fill.to,
                          "title"_a = plain_text(fill.title), "colour"_a = fill.colour));
  py::list names;
  constexpr std::array kOf = {"point", "curve", "area"};
  for (const ChartName& name : panel.names)
    names.append(py::dict("of"_a = kOf[static_cast<std::size_t>(name.of)],
                          "text"_a = plain_text(name.text), "places"_a = name.places));
  const py::object cells =
      panel.cells ? py::object(cells_dict(*panel.cells)) : py::object(py::none());
  return py::dict("x"_a = axis_dict(panel.x, largest_of(panel, false)),
                  "y"_a = axis_dict(panel.y, largest_of(panel, true)), "series"_a = series,
                  "fills"_a = fills, "levels"_a = panel.levels,
                  "heading"_a = plain_text(panel.heading), "height"_a = panel.height,
                  "remark"_a = plain_text(panel.remark), "names"_a = names, "cells"_a = cells);
}

}  // namespace

py::dict chart_dict(const Chart& chart) {
  using namespace py::literals;
  py::list rows;
  for (const std::vector<ChartPanel>& row : chart.rows) {
    py::list panels;
    for (const ChartPanel& panel : row) panels.append(panel_dict(panel));
    rows.append(panels);
  }
  py::list legend;
  for (const std::string& title : chart.legend) legend.append(plain_text(title));
  return py::dict("title"_a = plain_text(chart.title), "rows"_a = rows, "legend"_a = legend);
}

py::dict look_dicts() {
  py::dict groups;
  const auto add = [&](const char* name, const auto& looks) {
    py::dict group;
    for (const Look& look : looks) group[py::str(look.id)] = look_dict(look);
    groups[name] = group;
  };
  add("lines", line_looks());
  add("special", special_looks());
  add("loci", locus_looks());
  add("dots", dot_looks());
  add("grounds", ground_looks());
  py::list others, curves;
  for (const char* colour : other_grounds()) others.append(colour);
  for (const char* colour : curve_colours()) curves.append(colour);
  groups["other_grounds"] = others;
  groups["curves"] = curves;
  return groups;
}

std::pair<double, std::string> axis_unit_pair(const std::string& si_unit, double largest) {
  const AxisUnit unit = axis_unit(si_unit, largest);
  return {unit.factor, plain_text(unit.unit)};
}

}  // namespace graze
