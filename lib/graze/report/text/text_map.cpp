#include <fmt/format.h>

#include <map>

#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/detail/text_plane.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
std::string to_text(const MapRecord& record) {
  const AttractorMap& map = record.map;
  const double all = static_cast<double>(map.cells.size());
  std::string text = plane_text(map.options, record.x_unit, record.y_unit);
  Table table(
      {"settles on", "cells", "part", "first at " + map.options.x.name, map.options.y.name});
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    const MapAttractor& one = map.attractors[i];
    table.add({attractor_name(map, i), std::to_string(one.cells),
               fmt::format("{:.2f} %", 100.0 * static_cast<double>(one.cells) / all),
               fmt::format("{:.8g}", map.options.x_at(one.first)),
               fmt::format("{:.8g}", map.options.y_at(one.first))});
  }
  std::map<std::string, std::size_t> others;
  for (const MapCell& cell : map.cells)
    if (cell.place < 0) ++others[cell_name(map, cell)];
  for (const auto& [name, cells] : others)
    table.add({name, std::to_string(cells),
               fmt::format("{:.2f} %", 100.0 * static_cast<double>(cells) / all), "", ""});
  text += table.text();
  if (record.loci)
    text += fmt::format("\n{} loci of special points over it, from {} starts on {} slices\n",
                        record.loci->loci.size(), record.loci->starts, record.loci->slices);
  if (!record.outcome.message.empty())
    text += fmt::format("\n{}: {}\n", record.outcome.name, record.outcome.message);
  return text;
}

}  // namespace graze
