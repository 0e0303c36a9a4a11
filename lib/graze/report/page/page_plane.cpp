#include "graze/report/page/detail/page_plane.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>

#include "graze/report/chart/detail/chart_loci.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/page_tables.hpp"
#include "graze/scene/start_coordinate.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostMessages = 1'000;  // different ones

// The sentences of cells, each once, and which cell has which; null where none has any.
Json messages_json(const PageCells& cells, std::size_t count) {
  std::map<std::string, std::int32_t> known;
  Json texts = Json::array();
  std::vector<std::int32_t> of(count, -1);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const std::string& message = cells.message(i);
    if (message.empty()) continue;
    auto at = known.find(message);
    if (at == known.end()) {
      if (known.size() == kMostMessages) continue;
      at = known.emplace(message, static_cast<std::int32_t>(known.size())).first;
      texts.push_back(message);
    }
    of[i] = at->second;
  }
  if (texts.empty()) return nullptr;
  return {{"texts", texts}, {"of", packed(of)}};
}

// What the cells are, each with the first of its kind.
PageTable kinds_table(const Chart& chart) {
  const ChartPanel& panel = chart.rows[0][0];
  const ChartCells& cells = *panel.cells;
  const ChartThings& things = *chart.things;
  PageTable table{"",
                  {cells.name, "cells", "part", "first at " + plain_text(panel.x.name),
                   plain_text(panel.y.name)},
                  {}};
  const std::size_t count = cells.ground.size();
  for (std::size_t kind = 0; kind < things.kinds.size(); ++kind) {
    const auto end = things.kind.begin() + static_cast<std::ptrdiff_t>(count);
    const auto first = std::find(things.kind.begin(), end, static_cast<int>(kind));
    if (first == end) continue;
    const auto cell = static_cast<std::size_t>(first - things.kind.begin());
    const auto alike = std::count(first, end, static_cast<int>(kind));
    table.rows.push_back(
        {things.kinds[kind].title, std::to_string(alike),
         fmt::format("{:.4g} %", 100.0 * static_cast<double>(alike) / static_cast<double>(count)),
         measured_text(cells.middles[0][cell % cells.columns], panel.x.unit, 7),
         measured_text(cells.middles[1][cell / cells.columns], panel.y.unit, 7)});
    table.opens.push_back(static_cast<int>(cell));
  }
  table.name = fmt::format("{} kinds of cells", table.rows.size());
  return table;
}

PageTable special_table(const Chart& chart, const OrbitLoci& traced) {
  const ChartPanel& panel = chart.rows[0][0];
  PageTable table{"", {"special point", plain_text(panel.x.name), plain_text(panel.y.name)}, {}};
  for (const OrbitLocus& locus : traced.loci)
    for (const OrbitLocusSpecial& point : locus.special)
      table.rows.push_back({special_title(locus, point),
                            measured_text(point.at.value, panel.x.unit, 10),
                            measured_text(point.at.second, panel.y.unit, 10)});
  table.name = fmt::format("{} points of codimension two", table.rows.size());
  return table;
}

}  // namespace

void write_plane(const std::string& file, const Chart& chart, Json view, const PageCells* cells,
                 const OrbitLoci* traced, const std::vector<PageTable>& more) {
  std::vector<PageTable> tables;
  if (cells) {
    tables.push_back(kinds_table(chart));
    view["things"]["kept"] = packed(cells->kept);
    view["cells"] = {{"messages", messages_json(*cells, chart.rows[0][0].cells->ground.size())},
                     {"command", cells->command},
                     {"remarks", cells->remarks},
                     {"one", cells->is_one_motion}};
  }
  if (traced) tables.push_back(special_table(chart, *traced));
  tables.insert(tables.end(), more.begin(), more.end());
  view["tables"] = tables_json(tables);
  write_page_file(file, view, cells ? cells->motions : Json::array());
}

Json cell_command_json(const std::string& before, const std::string& after, const Plane& plane,
                       const Scene& scene) {
  Json command = {{"before", before}, {"after", after}, {"paths", {plane.x.name, plane.y.name}}};
  Scene started = scene;
  for (const PlaneAxis* axis : {&plane.x, &plane.y})
    if (names_start_coordinate(axis->name)) start_coordinate(started, axis->name);
  if (!started.initial) return command;
  const Initial& initial = *started.initial;
  const auto add = [&](const char* own, const std::vector<double>& coordinates, const char* modal,
                       const std::vector<double>& modes) {
    command["start"][coordinates.empty() ? modal : own] = coordinates.empty() ? modes : coordinates;
  };
  add("displacement", initial.displacement, "q", initial.q);
  add("velocity", initial.velocity, "qdot", initial.qdot);
  return command;
}

}  // namespace graze
