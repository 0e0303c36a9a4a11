#include "graze/report/picture/detail/map_legend.hpp"

#include <iterator>
#include <map>
#include <utility>

#include "graze/report/names/detail/map_names.hpp"

namespace graze {
namespace {

// Attractors that repeat, by their cells; what never does is dark.
void add_attractors(const AttractorMap& map, MapLegend& legend) {
  constexpr std::size_t kOthers = static_cast<std::size_t>(-1);
  std::size_t orbits = 0;
  bool others = false;
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    const std::string name = attractor_name(map, i);
    const bool wild = map.attractors[i].attractor.status == SweepStatus::kNotPeriodic;
    const bool named = wild || orbits < std::size(kOrbitCells);
    legend.kinds.push_back({name, named ? legend.entries.size() : kOthers});
    if (named) legend.entries.push_back({name, wild ? kWildCell : kOrbitCells[orbits++]});
    others = others || !named;
  }
  if (!others) return;
  for (MapLegend::Kind& kind : legend.kinds)
    if (kind.entry == kOthers) kind.entry = legend.entries.size();
  legend.entries.push_back({"other orbits", kOtherCell});
}

// What has no motion is pale.
const char* colour_without_attractor(const MapCell& cell) {
  return cell.attractor.status == SweepStatus::kNoStart ? kNoCell : kOtherCell;
}

}  // namespace

MapLegend map_legend(const AttractorMap& map) {
  MapLegend legend;
  add_attractors(map, legend);
  const auto without = [](const MapCell& cell) { return cell.is_known && cell.place < 0; };
  std::map<std::pair<std::string, std::string>, int> rest;  // name and colour: the kind
  for (const MapCell& cell : map.cells)
    if (without(cell))
      rest.emplace(std::pair(cell_name(map, cell), colour_without_attractor(cell)), 0);
  for (auto& [shown, kind] : rest) {
    kind = static_cast<int>(legend.kinds.size());
    legend.kinds.push_back({shown.first, legend.entries.size()});
    legend.entries.push_back({shown.first, shown.second});
  }
  for (const MapCell& cell : map.cells)
    legend.kind_of.push_back(without(cell)
                                 ? rest.at({cell_name(map, cell), colour_without_attractor(cell)})
                                 : cell.place);
  return legend;
}

CellScale scale_of(MapQuantity quantity) {
  return quantity == MapQuantity::kExponent ? CellScale::kUnbounded : CellScale::kFromZero;
}

}  // namespace graze
