#include <fmt/format.h>

#include <map>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/names/plane_names.hpp"
#include "graze/report/text/detail/folding.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/detail/text_plane.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

std::string to_text(const MapRecord& record, const TextOptions& options) {
  const AttractorMap& map = record.map;
  const std::size_t all = map.cells.size();
  std::string text = plane_text(map.options, record.x_unit, record.y_unit);
  Table table(
      {"settles on", "cells", "part", "first at " + map.options.x.name, map.options.y.name});
  std::vector<std::size_t> sizes;
  for (const MapAttractor& one : map.attractors) sizes.push_back(one.cells);
  const std::vector<bool> is_folded = folded_groups(sizes, all);
  Folded folded;
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    const MapAttractor& one = map.attractors[i];
    if (is_folded[i])
      folded.add(one.cells);
    else
      table.add({attractor_title(map, i), std::to_string(one.cells), share_text(one.cells, all),
                 digits_text(map.options.x_at(one.first), 8),
                 digits_text(map.options.y_at(one.first), 8)});
  }
  std::map<std::string, std::size_t> others;
  for (const MapCell& cell : map.cells)
    if (cell.place < 0) ++others[cell_name(map, cell)];
  for (const auto& [name, cells] : others)
    table.add({name, std::to_string(cells), share_text(cells, all), "", ""});
  text += table.text(options.width) + folded.text(all);
  if (record.loci)
    text += fmt::format("\n{} loci of special points over it, from {} starts on {} slices\n",
                        record.loci->loci.size(), record.loci->starts, record.loci->slices);
  return text + (record.outcome.message.empty() ? "" : "\n" + ending(record.outcome));
}

}  // namespace graze
