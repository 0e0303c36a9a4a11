#include <cmath>

#include "graze/record/names/detail/comparison_names.hpp"
#include "graze/report/picture/detail/map_legend.hpp"
#include "graze/report/picture/detail/picture_cells.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

CellColours agreement_colours(const ComparisonMap& map) {
  const MapLegend legend = comparison_legend(map);
  CellColours result;
  for (const auto& [name, colour] : legend.entries) result.legend.emplace_back(name, colour);
  result.of = [legend](std::size_t i) {
    const int kind = legend.kind_of[i];
    if (kind < 0) return Colour{};
    return colour_of(legend.entries[legend.kinds[static_cast<std::size_t>(kind)].entry].colour);
  };
  return result;
}

}  // namespace

void draw_comparison(const PictureRequest& request, const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  if (record.shown == ComparedQuantity::kAttractor) {
    draw_cells(request, {record.info, map.options, record.x_unit, record.y_unit},
               agreement_colours(map));
    return;
  }
  CellNumbers numbers;
  numbers.of = [&](std::size_t i) {
    const ComparedCell& cell = map.cells[i];
    return is_comparable(cell) ? compared_value(cell.difference, record.shown) : std::nan("");
  };
  numbers.without = [&](std::size_t i) {
    return map.cells[i].is_known ? cell_name(map.cells[i]) : "not run";
  };
  numbers.title = gnuplot_string(title_of(record.shown));
  if (is_signed(record.shown)) numbers.scale = CellScale::kSigned;
  draw_cells(request, {record.info, map.options, record.x_unit, record.y_unit}, numbers);
}

}  // namespace graze
