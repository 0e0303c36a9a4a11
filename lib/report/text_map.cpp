#include <fmt/format.h>

#include <map>

#include "graze/report/map_names.hpp"
#include "graze/report/sweep_names.hpp"
#include "graze/report/table.hpp"
#include "graze/report/text.hpp"

namespace graze {
namespace {

std::string axis_text(const MapAxis& axis, const std::string& unit) {
  return fmt::format("{} from {:g} to {:g}{}{}", axis.name, axis.from, axis.to,
                     unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string to_text(const MapRecord& record) {
  const AttractorMap& map = record.map;
  const auto columns = static_cast<std::size_t>(map.options.x.points);
  const double all = static_cast<double>(map.cells.size());
  std::string text =
      fmt::format("{} by {} cells, {}, {}\n", map.options.x.points, map.options.y.points,
                  axis_text(map.options.x, record.x_unit), axis_text(map.options.y, record.y_unit));
  Table table(
      {"settles on", "cells", "part", "first at " + map.options.x.name, map.options.y.name});
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    const MapAttractor& one = map.attractors[i];
    table.add({attractor_name(map, i), std::to_string(one.cells),
               fmt::format("{:.2f} %", 100.0 * static_cast<double>(one.cells) / all),
               fmt::format("{:.8g}", map.options.x.value(static_cast<int>(one.first % columns))),
               fmt::format("{:.8g}", map.options.y.value(static_cast<int>(one.first / columns)))});
  }
  std::map<std::string, std::size_t> others;
  for (const MapCell& cell : map.cells)
    if (cell.place < 0) ++others[cell_name(map, cell)];
  for (const auto& [name, cells] : others)
    table.add({name, std::to_string(cells),
               fmt::format("{:.2f} %", 100.0 * static_cast<double>(cells) / all), "", ""});
  text += table.text();
  if (!record.outcome.message.empty())
    text += fmt::format("\n{}: {}\n", record.outcome.name, record.outcome.message);
  return text;
}

}  // namespace graze
