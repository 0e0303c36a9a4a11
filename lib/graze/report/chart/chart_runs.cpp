#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/probes.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"

namespace graze {
namespace {

constexpr std::size_t kMost = 3;  // stops or probes with panels of their own

// An axis of a parameter, over all its values.
ChartAxis parameter_axis(const std::string& path, const std::string& unit) {
  return {.name = parameter_title(path), .unit = unit, .path = path};
}

ChartSeries dots_of(const char* title, const char* colour) {
  return {title, {.colour = colour, .mark = MarkShape::kDot, .size = 0.3}, false, true, {}, {}};
}

ChartPanel impacts_panel(const RunDiagramRecord& record, int stop) {
  ChartPanel panel{parameter_axis(record.parameter, record.unit),
                   {.name = record.stops == 1 ? "impact speed"
                                              : fmt::format("impact speed\nat stop {}", stop + 1),
                    .unit = unit_in(record.info.units, "m/s"),
                    .from_zero = true}};
  panel.x.range.include(record.from);
  panel.x.range.include(record.to);
  panel.height = 5.2;
  ChartSeries later = dots_of("later impacts", kOrange), first = dots_of("first impact", kBlue);
  for (const ValueRun& run : record.runs)
    for (const RunImpact& impact : run.impacts) {
      if (impact.stop != stop) continue;
      ChartSeries& series = &impact == run.impacts.data() ? first : later;
      series.x.push_back(run.value);
      series.y.push_back(impact.speed);
    }
  if (first.x.empty() && later.x.empty()) panel.remark = "no impacts";
  panel.series = {later, first};
  return panel;
}

ChartPanel peaks_panel(const RunDiagramRecord& record, std::size_t probe) {
  const ProbeQuantity quantity = record.probes[probe].quantity;
  ChartPanel panel{parameter_axis(record.parameter, record.unit),
                   {.name = fmt::format("largest\n|{}|", probe_quantity_name(quantity)),
                    .unit = unit_in(record.info.units, probe_unit(quantity)),
                    .from_zero = true}};
  panel.x.range.include(record.from);
  panel.x.range.include(record.to);
  panel.height = 3.1;
  ChartSeries series{"", {.colour = kBlack, .width = 1.5}, true, false, {}, {}};
  for (const ValueRun& run : record.runs) {
    series.x.push_back(run.value);
    series.y.push_back(run.peaks[probe]);
  }
  panel.series.push_back(series);
  return panel;
}

ChartPanel sensitivity_panel(const SensitivityRecord& record, std::size_t probe,
                             const std::string& name, Matrix SensitivityCurve::*part) {
  ChartPanel panel{
      parameter_axis(record.parameter, record.unit),
      {.name = fmt::format("{} (%)\n{}", name, probe_quantity_name(record.probes[probe].quantity)),
       .from_zero = true}};
  panel.height = 3.1;
  panel.levels = {0.0};
  for (std::size_t c = 0; c < std::min(record.curves.size(), curve_colours().size()); ++c) {
    const SensitivityCurve& curve = record.curves[c];
    ChartSeries series{record.second.empty()
                           ? ""
                           : fmt::format("{} {:.4g} {}", parameter_title(record.second),
                                         curve.second, record.second_unit),
                       curve_look(c),
                       true,
                       false,
                       {},
                       {}};
    for (std::size_t k = 0; k < curve.runs.size(); ++k) {
      series.x.push_back(curve.runs[k].value);
      series.y.push_back(
          100.0 * (curve.*part)(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(probe)));
    }
    panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

Chart chart_of(const RunDiagramRecord& record) {
  Chart chart{"Runs over a parameter", {}};
  for (std::size_t i = 0; i < std::min(record.stops, kMost); ++i)
    chart.rows.push_back({impacts_panel(record, static_cast<int>(i))});
  for (std::size_t i = 0; i < std::min(record.probes.size(), kMost); ++i)
    chart.rows.push_back({peaks_panel(record, i)});
  return chart;
}

Chart chart_of(const SensitivityRecord& record) {
  Chart chart{"Sensitivity", {}};
  for (std::size_t i = 0; i < std::min(record.probes.size(), kMost); ++i) {
    chart.rows.push_back({sensitivity_panel(record, i, "s_1", &SensitivityCurve::s1)});
    chart.rows.push_back({sensitivity_panel(record, i, "s_2", &SensitivityCurve::s2)});
  }
  return chart;
}

}  // namespace graze
