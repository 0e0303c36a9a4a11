#include "graze/report/chart/detail/chart_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace graze {
namespace {

constexpr double kCellsHeight = 7.0;  // cm
// Cells without a number because their motions meet no stop.
constexpr std::array kClear = {"no impact", "both no impact"};

// Colours of equal steps in lightness, dark to bright (after M. Kuhn's and N. Smith's viridis), and
// two hues away from zero.
constexpr std::array kScale = {"#440154", "#3B528B", "#21918C", "#5EC962", "#FDE725"};
constexpr std::array kAboutZero = {"#2166AC", "#92C5DE", "#F7F7F7", "#F4A582", "#B2182B"};

}  // namespace

CellBar cell_bar(std::size_t cells, const std::function<double(std::size_t cell)>& of,
                 CellScale scale) {
  AxisRange range;
  for (std::size_t i = 0; i < cells; ++i) range.include(of(i));
  bool has_two_hues = scale == CellScale::kSigned;
  if (scale == CellScale::kFromZero) range.include(0.0);
  if (scale == CellScale::kSigned)
    for (const double end : {range.low, range.high}) range.include(-end);
  if (scale == CellScale::kUnbounded && range.low < 0.0 && range.high > 0.0) {
    has_two_hues = true;
    range.low = -range.high;
  }
  range.settle(0.0);
  return {range, has_two_hues ? kAboutZero : kScale};
}

AxisRange cell_range(const PlaneAxis& axis) {
  const double half = 0.5 * std::abs(axis.to - axis.from) / (axis.points - 1);
  AxisRange range;
  range.include(std::min(axis.from, axis.to) - half);
  range.include(std::max(axis.from, axis.to) + half);
  return range;
}

ChartPanel cells_panel(const Plane& plane, const std::string& x_unit, const std::string& y_unit) {
  const auto axis = [](const PlaneAxis& of, const std::string& unit) {
    return ChartAxis{
        .name = parameter_title(of.name), .unit = unit, .range = cell_range(of), .path = of.name};
  };
  ChartPanel panel{.x = axis(plane.x, x_unit), .y = axis(plane.y, y_unit), .height = kCellsHeight};
  const auto edges = [](const PlaneAxis& of) {
    const double half = 0.5 * (of.to - of.from) / (of.points - 1);
    return std::array{of.from - half, of.to + half};
  };
  panel.cells = ChartCells{.columns = static_cast<std::size_t>(plane.x.points),
                           .rows = static_cast<std::size_t>(plane.y.points),
                           .x = edges(plane.x),
                           .y = edges(plane.y),
                           .grounds = {},
                           .ground = std::vector<int>(plane.cells(), -1)};
  for (int i = 0; i < plane.x.points; ++i) panel.cells->middles[0].push_back(plane.x.value(i));
  for (int i = 0; i < plane.y.points; ++i) panel.cells->middles[1].push_back(plane.y.value(i));
  return panel;
}

void set_numbers(const CellNumbers& numbers, ChartCells& cells) {
  const std::size_t count = cells.ground.size();
  const CellBar bar = cell_bar(count, numbers.of, numbers.scale);
  cells.bar = {.name = numbers.title, .unit = numbers.unit, .range = bar.range};
  cells.colours.assign(bar.colours.begin(), bar.colours.end());
  std::map<std::string, int> grounds;  // of what has no number
  for (std::size_t i = 0; i < count; ++i) {
    cells.numbers.push_back(numbers.of(i));
    if (!std::isfinite(cells.numbers.back())) grounds.emplace(numbers.without(i), -1);
  }
  const auto add = [&](int& ground, const std::string& title, const std::string& colour) {
    ground = static_cast<int>(cells.grounds.size());
    cells.grounds.push_back({title, colour});
  };
  // White stands for "no impact", in every picture with such cells.
  for (const char* name : kClear)
    if (const auto clear = grounds.find(name); clear != grounds.end())
      add(clear->second, std::string(name) + " (blank)", ground_look("blank").colour);
  const std::span<const char* const> without = grounds_without_motion();
  std::size_t next = 0;
  for (auto& [name, ground] : grounds)
    if (ground < 0) add(ground, name, without[std::min(next++, without.size() - 1)]);
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(cells.numbers[i])) cells.ground[i] = grounds.at(numbers.without(i));
}

}  // namespace graze
