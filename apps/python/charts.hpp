// Charts and looks of the library (report/chart, report/appearance) as plain Python values, for
// matplotlib to draw what gnuplot and the pages draw.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <utility>

#include "graze/record/stored/detail/record_file.hpp"
#include "graze/report/chart/chart.hpp"

namespace graze {

// {"title", "rows": [[panel, ..], ..]}, every panel as chart.hpp has it, values in SI units.
pybind11::dict chart_dict(const Chart& chart);

// All looks: {group: {id: look}}.
pybind11::dict look_dicts();

// (factor, unit) in which SI values up to `largest` are read best, and the label of a parameter.
std::pair<double, std::string> axis_unit_pair(const std::string& si_unit, double largest);
std::string plain_parameter_title(const std::string& path);

// What a picture of a plane of cells shows: "x" and "y" (SI) with their "x_name", "x_unit", ..; and
// either "legend" (name and colour of each entry) and "entry" (of every cell, row by row; -1:
// none), or "values" of the cells (SI) with "title", "unit", "is_signed".
pybind11::dict plane_dict(const MapRecord& record);
pybind11::dict plane_dict(const ComparisonMapRecord& record);

// What a picture of the record shows, where that is a chart.
std::optional<Chart> chart_shown(const CheckRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const ModesRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const SimulationRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const OrbitRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const ComparisonRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const BranchRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const DiagramRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const SensitivityRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const RunDiagramRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const CostRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const FitRecord& record, const Scene& scene);
// Those of which pictures of their own are drawn.
std::optional<Chart> chart_shown(const LociRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const MapRecord& record, const Scene& scene);
std::optional<Chart> chart_shown(const ComparisonMapRecord& record, const Scene& scene);

}  // namespace graze
