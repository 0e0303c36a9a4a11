#include "graze/report/chart/detail/map_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/names/plane_names.hpp"

namespace graze {
namespace {

// Attractors that repeat, sorted by their cells. The first of a kind gets the kind's ground; others
// of that kind, and other kinds, get the next free one; the rest share one entry.
void add_attractors(const AttractorMap& map, MapLegend& legend) {
  constexpr std::size_t kRest = static_cast<std::size_t>(-1);
  std::size_t next = 0, rest = 0;
  std::map<std::string, int> given;  // grounds of kinds
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    const std::string name = attractor_title(map, i);
    const Look* fixed = ground_of(map.attractors[i].attractor);
    std::string colour;
    if (fixed && given[fixed->id]++ == 0)
      colour = fixed->colour;
    else if (next < other_grounds().size())
      colour = other_grounds()[next++];
    legend.kinds.push_back({name, colour.empty() ? kRest : legend.entries.size()});
    if (!colour.empty()) legend.entries.push_back({name, colour});
    if (colour.empty()) ++rest;
  }
  if (rest == 0) return;
  for (MapLegend::Kind& kind : legend.kinds)
    if (kind.entry == kRest) kind.entry = legend.entries.size();
  legend.entries.push_back(
      {rest == 1 ? legend.kinds.back().name : fmt::format("{} other motions", rest),
       ground_look("other").colour});
}

}  // namespace

const Look* ground_of(const AttractorClass& attractor) {
  if (attractor.wandering == Wandering::kTorus) return &ground_look("torus");
  if (attractor.status == SweepStatus::kNotPeriodic) return &ground_look("wild");
  if (attractor.period == 0) return nullptr;
  if (attractor.kind == SettledKind::kSticks || attractor.kind == SettledKind::kAtRest)
    return &ground_look("sticks");
  return fixed_ground(attractor_label(attractor));
}

MapLegend map_legend(const AttractorMap& map) {
  MapLegend legend;
  add_attractors(map, legend);
  const auto without = [](const MapCell& cell) { return cell.is_known && cell.place < 0; };
  std::map<std::string, int> rest;  // the kind, by name
  for (const MapCell& cell : map.cells)
    if (without(cell)) rest.emplace(cell_name(map, cell), 0);
  const std::span<const char* const> grounds = grounds_without_motion();
  std::size_t next = 0;
  for (auto& [name, kind] : rest) {
    kind = static_cast<int>(legend.kinds.size());
    legend.kinds.push_back({name, legend.entries.size()});
    legend.entries.push_back({name, grounds[std::min(next++, grounds.size() - 1)]});
  }
  for (const MapCell& cell : map.cells)
    legend.kind_of.push_back(without(cell) ? rest.at(cell_name(map, cell)) : cell.place);
  return legend;
}

MapLegend comparison_legend(const ComparisonMap& map) {
  std::map<std::string, std::size_t> counts;
  std::map<std::string, std::string> colours;
  for (const ComparedCell& cell : map.cells) {
    if (!cell.is_known) continue;
    const std::string name = cell_name(cell);
    ++counts[name];
    if (!is_comparable(cell))
      colours[name] = ground_look("none").colour;
    else if (!cell.difference.is_same_attractor)
      colours[name] = ground_look("differs").colour;
    else if (const Look* fixed = ground_of(cell.one))
      colours[name] = fixed->colour;
  }
  std::vector<std::pair<std::string, std::size_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  MapLegend legend;
  std::map<std::string, int> kinds;
  std::vector<std::size_t> rest;  // kinds without a colour of their own
  std::size_t next = 0;
  for (const auto& [name, count] : order) {
    if (!colours.contains(name) && next < other_grounds().size())
      colours[name] = other_grounds()[next++];
    kinds[name] = static_cast<int>(legend.kinds.size());
    if (!colours.contains(name)) rest.push_back(legend.kinds.size());
    legend.kinds.push_back({name, legend.entries.size()});
    if (colours.contains(name)) legend.entries.push_back({name, colours[name]});
  }
  for (const std::size_t kind : rest) legend.kinds[kind].entry = legend.entries.size();
  if (!rest.empty())
    legend.entries.push_back(
        {fmt::format("both one of {} other motions", rest.size()), ground_look("other").colour});
  for (const ComparedCell& cell : map.cells)
    legend.kind_of.push_back(cell.is_known ? kinds.at(cell_name(cell)) : -1);
  return legend;
}

void set_grounds(const MapLegend& legend, ChartCells& cells) {
  for (const auto& [name, colour] : legend.entries) cells.grounds.push_back({name, colour});
  for (std::size_t i = 0; i < cells.ground.size(); ++i)
    if (legend.kind_of[i] >= 0)
      cells.ground[i] =
          static_cast<int>(legend.kinds[static_cast<std::size_t>(legend.kind_of[i])].entry);
}

ChartThings explored_cells(const MapLegend& legend, const std::string& name,
                           const std::vector<CellNumbers>& numbers, const std::string& shown,
                           ChartCells& cells) {
  set_grounds(legend, cells);
  cells.name = name;
  cells.shown = shown;
  ChartThings things;
  things.kind = legend.kind_of;
  for (const MapLegend::Kind& kind : legend.kinds)
    things.kinds.push_back({kind.name, kind.name, ""});
  for (const CellNumbers& number : numbers) {
    const std::size_t count = cells.ground.size();
    const CellBar bar = cell_bar(count, number.of, number.scale);
    ChartThings::Number made{
        .axis = {.name = number.title, .unit = number.unit, .range = bar.range, .key = number.key},
        .is_axis = false,
        .colours = {bar.colours.begin(), bar.colours.end()},
        .rough = count};
    for (std::size_t i = 0; i < count; ++i) made.values.push_back(number.of(i));
    things.numbers.push_back(std::move(made));
  }
  return things;
}

CellScale scale_of(MapQuantity quantity) {
  if (quantity == MapQuantity::kMeasured) return CellScale::kAsIs;
  return quantity == MapQuantity::kExponent ? CellScale::kUnbounded : CellScale::kFromZero;
}

}  // namespace graze
