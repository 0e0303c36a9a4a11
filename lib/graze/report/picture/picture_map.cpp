#include "graze/report/names/detail/map_names.hpp"
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

void draw_map(const std::string& file, const MapRecord& record) {
  const AttractorMap& map = record.map;
  const DrawnPlane plane{map.options, record.x_unit, record.y_unit,
                         record.loci ? &*record.loci : nullptr};
  if (record.shown == MapQuantity::kAttractor) {
    draw_cells(file, plane, attractor_colours(map));
    return;
  }
  CellNumbers numbers;
  numbers.of = [&](std::size_t i) { return cell_value(map.cells[i], record.shown); };
  numbers.is_known = [&](std::size_t i) { return map.cells[i].is_known; };
  numbers.title = axis_label(title_of(record.shown), unit_of(record.shown));
  numbers.scale = scale_of(record.shown);
  draw_cells(file, plane, numbers);
}

}  // namespace graze
