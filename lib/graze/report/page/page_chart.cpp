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
  if (!axis.key.empty()) json["key"] = axis.key;
  return json;
}

// The things of dots, which come in runs: each with the number of its points.
Json runs_json(const std::vector<int>& of) {
  std::vector<std::int32_t> things, counts;
  for (const int thing : of) {
    if (things.empty() || things.back() != thing) {
      things.push_back(thing);
      counts.push_back(0);
    }
    ++counts.back();
  }
  return {{"thing", packed(things)}, {"count", packed(counts)}};
}

// `is_of_numbers`: the page has its points from the numbers of their things.
Json series_json(const ChartSeries& series, bool is_of_numbers) {
  Json json = {{"title", plain_text(series.title)},
               {"look", look_json(series.look)},
               {"line", series.is_line},
               {"marks", series.has_marks}};
  if (!is_of_numbers) {
    json["x"] = packed(series.x);
    json["y"] = packed(series.y);
  }
  if (series.are_dots) json["dots"] = true;
  if (!series.of.empty() && series.are_dots) json["runs"] = runs_json(series.of);
  if (!series.of.empty() && !series.are_dots) json["of"] = packed(series.of);
  if (!series.which.empty() && !series.are_dots) json["which"] = packed(series.which);
  if (!series.error.empty()) json["error"] = packed(series.error);
  return json;
}

// Bytes while they can count them, -1 as 255.
Json packed_indices(const std::vector<int>& indices, std::size_t count) {
  if (count >= 255) return packed(indices);
  std::vector<std::uint8_t> bytes;
  for (const int index : indices)
    bytes.push_back(index < 0 ? 255 : static_cast<std::uint8_t>(index));
  return packed(bytes);
}

Json thing_number_json(const ChartThings::Number& number) {
  const auto rough_end = number.values.begin() + static_cast<std::ptrdiff_t>(number.rough);
  Json json = axis_json(number.axis, {}, 0.0);
  json["single"] = number.is_single;
  json["axis"] = number.is_axis;
  json["has_logarithm"] = std::any_of(number.values.begin(), number.values.end(),
                                      [](double value) { return value > 0.0; });
  json["given"] = !number.axis.path.empty();
  json["rough"] = packed(std::vector<float>(number.values.begin(), rough_end));
  json["exact"] = packed(std::vector<double>(rough_end, number.values.end()));
  if (!number.is_single)
    json["first"] = packed(std::vector<std::int32_t>(number.first.begin(), number.first.end()));
  if (!number.colours.empty()) json["colours"] = number.colours;
  if (number.level) json["level"] = *number.level;
  if (number.turn) json["turn"] = *number.turn;
  return json;
}

Json things_json(const ChartThings& things) {
  Json kinds = Json::array(), numbers = Json::array(), more = Json::object();
  for (const auto& [title, of, name] : things.kinds)
    kinds.push_back({{"title", title}, {"of", of}, {"name", name}});
  for (const ChartThings::Number& number : things.numbers)
    numbers.push_back(thing_number_json(number));
  for (const auto& [thing, rows] : things.more) more[std::to_string(thing)] = rows;
  return {{"kinds", kinds},
          {"kind", packed_indices(things.kind, things.kinds.size())},
          {"numbers", numbers},
          {"more", more}};
}

Json cells_json(const ChartCells& cells) {
  Json grounds = Json::array();
  for (const auto& [title, colour] : cells.grounds)
    grounds.push_back({{"title", title}, {"colour", colour}});
  return {{"columns", packed(cells.middles[0])},
          {"rows", packed(cells.middles[1])},
          {"grounds", grounds},
          {"ground", packed_indices(cells.ground, cells.grounds.size())},
          {"name", cells.name},
          {"shown", cells.shown}};
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
    series.push_back(series_json(one, !panel.x.key.empty() && !panel.y.key.empty()));
  }
  for (const double level : panel.levels) y.include(level);
  for (const ChartFill& fill : panel.fills)
    fills.push_back({{"upright", fill.is_upright},
                     {"from", json_number(fill.from)},
                     {"to", json_number(fill.to)},
                     {"title", plain_text(fill.title)},
                     {"colour", fill.colour}});
  Json json = {{"x", axis_json(panel.x, x, kAcross)},
               {"y", axis_json(panel.y, y, kUpright)},
               {"series", series},
               {"fills", fills},
               {"levels", panel.levels},
               {"height", panel.height},
               {"heading", plain_text(panel.heading)},
               {"remark", plain_text(panel.remark)}};
  if (panel.cells) json["cells"] = cells_json(*panel.cells);
  return json;
}

}  // namespace

Json tables_json(const std::vector<PageTable>& tables) {
  Json list = Json::array();
  for (const PageTable& table : tables)
    if (!table.rows.empty())
      list.push_back({{"name", table.name},
                      {"columns", table.columns},
                      {"rows", table.rows},
                      {"opens", table.opens}});
  return list;
}

Json chart_view(const Chart& chart, const RunInfo& info, const Outcome& outcome,
                const std::vector<std::string>& warnings, const std::vector<std::string>& notes,
                const std::vector<PageTable>& tables) {
  Json view = page_view(info, outcome, warnings, notes);
  view["kind"] = "chart";
  view["title"] = plain_text(chart.title);
  view["rows"] = Json::array();
  for (const std::vector<ChartPanel>& row : chart.rows) {
    Json panels = Json::array();
    for (const ChartPanel& panel : row) panels.push_back(panel_json(panel));
    view["rows"].push_back(std::move(panels));
  }
  view["layouts"] = Json::array();
  for (const ChartPanel& panel : chart.layouts) view["layouts"].push_back(panel_json(panel));
  view["legend"] = Json::array();
  for (const std::string& title : chart.legend) view["legend"].push_back(plain_text(title));
  if (chart.things) view["things"] = things_json(*chart.things);
  view["tables"] = tables_json(tables);
  return view;
}

void write_page(const std::string& file, const Chart& chart, const RunInfo& info,
                const Outcome& outcome, const std::vector<std::string>& warnings,
                const std::vector<PageTable>& tables) {
  write_page_file(file, chart_view(chart, info, outcome, warnings, {}, tables), Json::array());
}

}  // namespace graze
