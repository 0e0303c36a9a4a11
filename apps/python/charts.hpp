// Charts and looks of the library (report/chart, report/appearance) as plain Python values, for
// matplotlib to draw what gnuplot and the pages draw.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>

#include "graze/report/chart/chart.hpp"

namespace graze {

// {"title", "rows": [[panel, ..], ..]}, every panel as chart.hpp has it, values in SI units.
pybind11::dict chart_dict(const Chart& chart);

// All looks: {group: {id: look}}.
pybind11::dict look_dicts();

// (factor, unit) in which SI values up to `largest` are read best.
std::pair<double, std::string> axis_unit_pair(const std::string& si_unit, double largest);

}  // namespace graze
