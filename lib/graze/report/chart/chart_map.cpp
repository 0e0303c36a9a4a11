#include <cmath>

#include "graze/record/names/plane_names.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/chart_loci.hpp"
#include "graze/report/chart/detail/map_legend.hpp"

namespace graze {
namespace {

const char* title_of(const AttractorMap& map) {
  return map.is_of_starts ? "Basins of attraction" : "Map of attractors";
}

// All that a page may show.
std::vector<CellNumbers> numbers_of(const MapRecord& record) {
  const AttractorMap& map = record.map;
  std::vector<CellNumbers> numbers;
  const auto add = [&](MapQuantity quantity) {
    const DrawnQuantity drawn = drawn_quantity(record, quantity);
    numbers.push_back({.of = [&map, drawn](std::size_t i) { return drawn.of(map.cells[i]); },
                       .without = {},
                       .title = drawn.title,
                       .unit = drawn.unit,
                       .scale = scale_of(quantity),
                       .key = name_of(quantity)});
  };
  for (const MapQuantity quantity : kMapQuantities)
    if (quantity != MapQuantity::kAttractor &&
        (quantity != MapQuantity::kExponent || map.options.exponent_periods > 0))
      add(quantity);
  if (record.measured) add(MapQuantity::kMeasured);
  return numbers;
}

CellScale scale_of(ComparedQuantity quantity) {
  return is_signed(quantity) ? CellScale::kSigned : CellScale::kFromZero;
}

std::function<double(std::size_t)> compared(const ComparisonMap& map, ComparedQuantity quantity) {
  return [&map, quantity](std::size_t i) {
    const ComparedCell& cell = map.cells[i];
    return is_comparable(cell) ? compared_value(cell.difference, quantity) : std::nan("");
  };
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
                       return is_clear(cell) ? "no impact" : cell_name(map, cell);
                     },
                 .title = drawn.title,
                 .unit = drawn.unit,
                 .scale = scale_of(record.shown)},
                *panel.cells);
  if (record.loci) add_loci(*record.loci, panel);
  return {.title = title_of(map), .rows = {{std::move(panel)}}};
}

Chart explored_chart(const MapRecord& record) {
  ChartPanel panel = cells_panel(record.map.options, record.x_unit, record.y_unit);
  ChartThings things = explored_cells(map_legend(record.map), "attractor", numbers_of(record),
                                      name_of(record.shown), *panel.cells);
  if (record.loci) add_loci(*record.loci, panel, &things);
  return {.title = title_of(record.map), .rows = {{std::move(panel)}}, .things = std::move(things)};
}

Chart explored_chart(const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  ChartPanel panel = cells_panel(map.options, record.x_unit, record.y_unit);
  std::vector<CellNumbers> numbers;
  for (const ComparedQuantity quantity : kComparedQuantities)
    if (quantity != ComparedQuantity::kAttractor)
      numbers.push_back({.of = compared(map, quantity),
                         .without = {},
                         .title = title_of(quantity),
                         .unit = "",
                         .scale = scale_of(quantity),
                         .key = name_of(quantity)});
  ChartThings things = explored_cells(comparison_legend(map), "attractor", numbers,
                                      name_of(record.shown), *panel.cells);
  return {.title = "The scene against " + record.other,
          .rows = {{std::move(panel)}},
          .things = std::move(things)};
}

Chart chart_of(const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  ChartPanel panel = cells_panel(map.options, record.x_unit, record.y_unit);
  if (record.shown == ComparedQuantity::kAttractor)
    set_grounds(comparison_legend(map), *panel.cells);
  else
    set_numbers({.of = compared(map, record.shown),
                 .without =
                     [&](std::size_t i) {
                       return map.cells[i].is_known ? cell_name(map.cells[i]) : "not run";
                     },
                 .title = title_of(record.shown),
                 .unit = "",
                 .scale = scale_of(record.shown)},
                *panel.cells);
  return {.title = "The scene against " + record.other, .rows = {{std::move(panel)}}};
}

}  // namespace graze
