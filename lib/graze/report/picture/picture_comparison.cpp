#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/report/names/detail/comparison_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"
#include "graze/report/picture/detail/map_legend.hpp"
#include "graze/report/picture/detail/picture_cells.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

// What both settle on; where they differ it shows.
CellColours agreement_colours(const ComparisonMap& map) {
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
  CellColours result;
  std::size_t next = 0, rest = 0;
  for (const auto& [name, count] : order) {
    if (!colours.contains(name) && next < other_grounds().size())
      colours[name] = other_grounds()[next++];
    if (colours.contains(name))
      result.legend.emplace_back(name, colours[name]);
    else
      colours[name] = ground_look("other").colour, ++rest;
  }
  if (rest > 0)
    result.legend.emplace_back(fmt::format("both one of {} other motions", rest),
                               ground_look("other").colour);
  result.of = [&map, colours](std::size_t i) {
    const ComparedCell& cell = map.cells[i];
    return cell.is_known ? colour_of(colours.at(cell_name(cell))) : Colour{};
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
