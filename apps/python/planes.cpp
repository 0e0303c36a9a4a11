// Planes of cells as plain Python values, for matplotlib to draw what gnuplot draws.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>

#include "charts.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/record/names/detail/comparison_names.hpp"
#include "graze/record/names/detail/map_names.hpp"
#include "graze/report/picture/detail/map_legend.hpp"

namespace graze {
namespace {

namespace py = pybind11;

template <class Number>
py::array listed(const std::vector<Number>& list) {
  return py::array_t<Number>(static_cast<py::ssize_t>(list.size()), list.data());
}

template <class Record>
py::dict axes_dict(const Record& record) {
  using namespace py::literals;
  const auto& options = record.map.options;
  const auto values = [](const PlaneAxis& axis) {
    std::vector<double> list;
    for (int i = 0; i < axis.points; ++i) list.push_back(axis.value(i));
    return listed(list);
  };
  return py::dict("x"_a = values(options.x), "y"_a = values(options.y),
                  "x_name"_a = plain_parameter_title(options.x.name),
                  "y_name"_a = plain_parameter_title(options.y.name), "x_unit"_a = record.x_unit,
                  "y_unit"_a = record.y_unit);
}

py::dict with_legend(py::dict plane, const MapLegend& legend) {
  py::list entries;
  for (const MapLegend::Entry& entry : legend.entries)
    entries.append(py::make_tuple(plain_text(entry.name), entry.colour));
  std::vector<int> entry;
  for (const int kind : legend.kind_of)
    entry.push_back(
        kind < 0 ? -1 : static_cast<int>(legend.kinds[static_cast<std::size_t>(kind)].entry));
  plane["legend"] = entries;
  plane["entry"] = listed(entry);
  return plane;
}

py::dict with_values(py::dict plane, const std::vector<double>& values, const std::string& title,
                     const std::string& unit, bool is_signed) {
  plane["values"] = listed(values);
  plane["title"] = plain_text(title);
  plane["unit"] = unit;
  plane["is_signed"] = is_signed;
  return plane;
}

}  // namespace

py::dict plane_dict(const MapRecord& record) {
  if (record.shown == MapQuantity::kAttractor)
    return with_legend(axes_dict(record), map_legend(record.map));
  const DrawnQuantity drawn = drawn_quantity(record, record.shown);
  std::vector<double> values;
  for (const MapCell& cell : record.map.cells) values.push_back(drawn.of(cell));
  return with_values(axes_dict(record), values, drawn.title, drawn.unit,
                     scale_of(record.shown) == CellScale::kUnbounded);
}

py::dict plane_dict(const ComparisonMapRecord& record) {
  if (record.shown == ComparedQuantity::kAttractor)
    return with_legend(axes_dict(record), comparison_legend(record.map));
  std::vector<double> values;
  for (const ComparedCell& cell : record.map.cells)
    values.push_back(is_comparable(cell) ? compared_value(cell.difference, record.shown)
                                         : std::nan(""));
  return with_values(axes_dict(record), values, title_of(record.shown), "",
                     is_signed(record.shown));
}

}  // namespace graze
