#include <cmath>
#include <iterator>
#include <set>

#include "graze/report/map_names.hpp"
#include "graze/report/picture_cells.hpp"
#include "graze/report/pictures.hpp"

namespace graze {
namespace {

// Attractors that repeat, by their cells; what never does is dark, what has no motion pale.
CellColours attractor_colours(const AttractorMap& map) {
  CellColours result;
  std::vector<std::string> colours;  // of the attractors
  std::size_t orbits = 0;
  bool others = false;
  for (std::size_t i = 0; i < map.attractors.size(); ++i) {
    const bool wild = map.attractors[i].attractor.status == SweepStatus::kNotPeriodic;
    const bool named = wild || orbits < std::size(kOrbitCells);
    colours.emplace_back(wild ? kWildCell : named ? kOrbitCells[orbits++] : kOtherCell);
    if (named) result.legend.emplace_back(attractor_name(map, i), colours.back());
    others = others || !named;
  }
  if (others) result.legend.emplace_back("other orbits", kOtherCell);
  const auto colour_of_rest = [](const MapCell& cell) {
    return cell.attractor.status == SweepStatus::kNoStart ? kNoCell : kOtherCell;
  };
  std::set<std::pair<std::string, std::string>> rest;
  for (const MapCell& cell : map.cells)
    if (cell.place < 0 && cell.is_known) rest.emplace(cell_name(map, cell), colour_of_rest(cell));
  result.legend.insert(result.legend.end(), rest.begin(), rest.end());
  result.of = [&map, colours, colour_of_rest](std::size_t i) {
    const MapCell& cell = map.cells[i];
    if (cell.place >= 0) return colour_of(colours[static_cast<std::size_t>(cell.place)]);
    return cell.is_known ? colour_of(colour_of_rest(cell)) : Colour{};
  };
  return result;
}

std::string bar_title(MapQuantity shown) {
  switch (shown) {
    case MapQuantity::kAttractor:
      break;
    case MapQuantity::kImpacts:
      return gnuplot_string("impacts a forcing period");
    case MapQuantity::kExponent:
      return axis_label("largest exponent", "1/s");
    case MapQuantity::kSpeed:
      return axis_label("speed of the fastest impact", "m/s");
    case MapQuantity::kStuck:
      return gnuplot_string("part of the time at rest on a stop");
  }
  return gnuplot_string("");
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
  numbers.title = bar_title(record.shown);
  if (record.shown == MapQuantity::kExponent) numbers.scale = CellScale::kUnbounded;
  draw_cells(file, plane, numbers);
}

}  // namespace graze
