#include <cmath>

#include "graze/record/names/detail/comparison_names.hpp"
#include "graze/record/names/detail/map_names.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/chart_loci.hpp"
#include "graze/report/chart/detail/map_legend.hpp"

namespace graze {
namespace {

void set_grounds(const MapLegend& legend, ChartCells& cells) {
  for (const auto& [name, colour] : legend.entries) cells.grounds.push_back({name, colour});
  for (std::size_t i = 0; i < cells.ground.size(); ++i)
    if (legend.kind_of[i] >= 0)
      cells.ground[i] =
          static_cast<int>(legend.kinds[static_cast<std::size_t>(legend.kind_of[i])].entry);
}

}  // namespace

Chart chart_of(const MapRecord& record) {
  const AttractorMap& map = record.map;
  ChartPanel panel = cells_panel(map.options, record.x_unit, record.y_unit);
  const DrawnQuantity drawn = drawn_quantity(record, record.shown);
  if (record.shown == MapQuantity::kAttractor)
    set_grounds(map_legend(map), *panel.cells);
  else
    set_numbers({.of = [&](std::size_t i) { return drawn.of(map.cells[i]); },
                 .without =
                     [&](std::size_t i) {
                       const MapCell& cell = map.cells[i];
                       return is_clear(cell) ? "clear of the stops" : cell_name(map, cell);
                     },
                 .title = drawn.title,
                 .unit = drawn.unit,
                 .scale = scale_of(record.shown)},
                *panel.cells);
  if (record.loci) add_loci(*record.loci, panel);
  return {.title = map.is_of_starts ? "Basins of attraction" : "Map of attractors",
          .rows = {{std::move(panel)}}};
}

Chart chart_of(const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  ChartPanel panel = cells_panel(map.options, record.x_unit, record.y_unit);
  const auto of = [&](std::size_t i) {
    const ComparedCell& cell = map.cells[i];
    return is_comparable(cell) ? compared_value(cell.difference, record.shown) : std::nan("");
  };
  if (record.shown == ComparedQuantity::kAttractor)
    set_grounds(comparison_legend(map), *panel.cells);
  else
    set_numbers({.of = of,
                 .without =
                     [&](std::size_t i) {
                       return map.cells[i].is_known ? cell_name(map.cells[i]) : "not run";
                     },
                 .title = title_of(record.shown),
                 .unit = "",
                 .scale = is_signed(record.shown) ? CellScale::kSigned : CellScale::kFromZero},
                *panel.cells);
  return {.title = "The scene against " + record.other, .rows = {{std::move(panel)}}};
}

}  // namespace graze
