#include <algorithm>
#include <cmath>

#include "graze/record/names/detail/map_names.hpp"
#include "graze/report/picture/detail/map_legend.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

CellColours attractor_colours(const AttractorMap& map) {
  CellColours result;
  const MapLegend legend = map_legend(map);
  for (const auto& [name, colour] : legend.entries) result.legend.emplace_back(name, colour);
  result.of = [legend](std::size_t i) {
    if (legend.kind_of[i] < 0) return Colour{};
    return colour_of(
        legend.entries[legend.kinds[static_cast<std::size_t>(legend.kind_of[i])].entry].colour);
  };
  return result;
}

}  // namespace

void draw_map(const PictureRequest& request, const MapRecord& record) {
  const AttractorMap& map = record.map;
  const DrawnPlane plane{record.info, map.options, record.x_unit, record.y_unit,
                         record.loci ? &*record.loci : nullptr};
  if (record.shown == MapQuantity::kAttractor) {
    draw_cells(request, plane, attractor_colours(map));
    return;
  }
  CellNumbers numbers;
  const DrawnQuantity drawn = drawn_quantity(record, record.shown);
  double largest = 0.0;
  for (const MapCell& cell : map.cells)
    if (const double value = std::abs(drawn.of(cell)); std::isfinite(value))
      largest = std::max(largest, value);
  const AxisUnit unit = axis_unit(drawn.unit, largest);
  numbers.of = [&](std::size_t i) { return unit.factor * drawn.of(map.cells[i]); };
  numbers.without = [&](std::size_t i) {
    const MapCell& cell = map.cells[i];
    return is_clear(cell) ? "clear of the stops" : cell_name(map, cell);
  };
  numbers.title = axis_label(drawn.title, unit.unit);
  numbers.scale = scale_of(record.shown);
  draw_cells(request, plane, numbers);
}

}  // namespace graze
