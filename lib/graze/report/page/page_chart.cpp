#include "graze/report/page/detail/page_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page_looks.hpp"

namespace graze {
namespace {

constexpr double kAcross = 0.02,
                 kUpright = 0.06;  // left free beside what is drawn, parts of an axis

const char* name_of_scale(AxisScale scale) {
  switch (scale) {
    case AxisScale::kLog:
      return "log";
    case AxisScale::kDecibel:
      return "decibel";
    case AxisScale::kLinear:
      break;
  }
  return "linear";
}

// `drawn`: of what is drawn.
Json axis_json(const ChartAxis& axis, const AxisRange& drawn, double margin) {
  const bool given = !axis.range.empty();
  AxisRange range = given ? axis.range : drawn;
  if (!given && axis.from_zero) range.include(0.0);
  Json json = page_axis(axis.name, axis.unit, range, given ? 0.0 : margin);
  json["scale"] = name_of_scale(axis.scale);
  // On a logarithmic axis what is drawn is known only where it is drawn.
  json["given"] = given;
  json["hertz"] = has_hertz_axis(axis.path, axis.unit);
  return json;
}

Json series_json(const ChartSeries& series) {
  Json json = {{"title", plain_text(series.title)},
               {"look", look_json(series.look)},
               {"line", series.is_line},
               {"marks", series.has_marks},
               {"x", packed(series.x)},
               {"y", packed(series.y)}};
  if (!series.error.empty()) json["error"] = packed(series.error);
  if (series.are_dots) json["dots"] = true;
  return json;
}

Json panel_json(const ChartPanel& panel) {
  AxisRange x, y;
  Json series = Json::array(), fills = Json::array();
  for (const ChartSeries& one : panel.series) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      if (!std::isfinite(one.x[i]) || !std::isfinite(one.y[i])) continue;
      const double error = one.error.empty() ? 0.0 : one.error[i];
      x.include(one.x[i]);
      y.include(one.y[i] - error);
      y.include(one.y[i] + error);
    }
    series.push_back(series_json(one));
  }
  for (const double level : panel.levels) y.include(level);
  for (const ChartFill& fill : panel.fills)
    fills.push_back({{"upright", fill.is_upright},
                     {"from", json_number(fill.from)},
                     {"to", json_number(fill.to)},
                     {"title", plain_text(fill.title)},
                     {"colour", fill.colour}});
  return {{"x", axis_json(panel.x, x, kAcross)},
          {"y", axis_json(panel.y, y, kUpright)},
          {"series", series},
          {"fills", fills},
          {"levels", panel.levels},
          {"height", panel.height},
          {"heading", plain_text(panel.heading)},
          {"remark", plain_text(panel.remark)}};
}

}  // namespace

Json tables_json(const std::vector<PageTable>& tables) {
  Json list = Json::array();
  for (const PageTable& table : tables)
    if (!table.rows.empty())
      list.push_back({{"name", table.name}, {"columns", table.columns}, {"rows", table.rows}});
  return list;
}

void write_page(const std::string& file, const Chart& chart, const RunInfo& info,
                const Outcome& outcome, const std::vector<std::string>& warnings,
                const std::vector<PageTable>& tables) {
  Json view = page_view(info, outcome, warnings, {});
  view["kind"] = "chart";
  view["title"] = plain_text(chart.title);
  Json rows = Json::array();
  for (const std::vector<ChartPanel>& row : chart.rows) {
    Json panels = Json::array();
    for (const ChartPanel& panel : row) panels.push_back(panel_json(panel));
    rows.push_back(std::move(panels));
  }
  view["rows"] = rows;
  view["tables"] = tables_json(tables);
  write_page_file(file, view, Json::array());
}

}  // namespace graze
