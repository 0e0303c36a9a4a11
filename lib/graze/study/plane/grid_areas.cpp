#include "graze/study/plane/detail/grid_areas.hpp"

#include <algorithm>
#include <deque>
#include <functional>

namespace graze {
namespace {

class Grid {
 public:
  Grid(const std::vector<int>& keys, int columns)
      : keys_(keys), columns_(static_cast<std::size_t>(columns)) {}

  // Calls `visit` with each neighbour; returns how many of the four there are.
  int visit_neighbours(std::size_t cell, const std::function<void(std::size_t)>& visit) const {
    int count = 0;
    const auto meet = [&](bool there, std::size_t other) {
      if (!there) return;
      ++count;
      visit(other);
    };
    const std::size_t column = cell % columns_;
    meet(column > 0, cell - 1);
    meet(column + 1 < columns_, cell + 1);
    meet(cell >= columns_, cell - columns_);
    meet(cell + columns_ < keys_.size(), cell + columns_);
    return count;
  }

  // The cells connected with this one.
  std::vector<std::size_t> fill(std::size_t first, std::vector<bool>& seen) const {
    std::vector<std::size_t> cells{first};
    seen[first] = true;
    for (std::size_t i = 0; i < cells.size(); ++i)
      visit_neighbours(cells[i], [&](std::size_t other) {
        if (seen[other] || keys_[other] != keys_[first]) return;
        seen[other] = true;
        cells.push_back(other);
      });
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  std::size_t innermost(const std::vector<std::size_t>& cells) const {
    const std::vector<int> depths = depths_of(cells);
    const int deepest = *std::max_element(depths.begin(), depths.end());
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (depths[i] == deepest) candidates.push_back(cells[i]);
    double x = 0.0, y = 0.0;
    for (const std::size_t cell : candidates) {
      x += column(cell) / static_cast<double>(candidates.size());
      y += row(cell) / static_cast<double>(candidates.size());
    }
    const auto away = [&](std::size_t cell) {
      const double dx = column(cell) - x, dy = row(cell) - y;
      return dx * dx + dy * dy;
    };
    return *std::min_element(candidates.begin(), candidates.end(),
                             [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
  }

 private:
  double column(std::size_t cell) const { return static_cast<double>(cell % columns_); }
  double row(std::size_t cell) const {
    const std::size_t whole = cell / columns_;
    return static_cast<double>(whole);
  }

  // Number of edges from each cell to the nearest one at the area's boundary.
  std::vector<int> depths_of(const std::vector<std::size_t>& cells) const {
    const auto index = [&](std::size_t cell) {
      return static_cast<std::size_t>(std::lower_bound(cells.begin(), cells.end(), cell) -
                                      cells.begin());
    };
    std::vector<int> depths(cells.size(), -1);
    std::deque<std::size_t> waiting;
    for (const std::size_t cell : cells) {
      bool at_boundary = false;
      const int count = visit_neighbours(cell, [&](std::size_t other) {
        at_boundary = at_boundary || keys_[other] != keys_[cell];
      });
      if (!at_boundary && count == 4) continue;
      depths[index(cell)] = 0;
      waiting.push_back(cell);
    }
    while (!waiting.empty()) {
      const std::size_t cell = waiting.front();
      waiting.pop_front();
      // All neighbours belong to the area: cells at its boundary have their depth already.
      visit_neighbours(cell, [&](std::size_t other) {
        if (keys_[other] != keys_[cell] || depths[index(other)] >= 0) return;
        depths[index(other)] = depths[index(cell)] + 1;
        waiting.push_back(other);
      });
    }
    return depths;
  }

  const std::vector<int>& keys_;
  std::size_t columns_;
};

}  // namespace

GridAreas grid_areas(const std::vector<int>& keys, int columns) {
  const Grid grid(keys, columns);
  std::vector<std::vector<std::size_t>> found;
  std::vector<bool> seen(keys.size());
  for (std::size_t cell = 0; cell < keys.size(); ++cell)
    if (!seen[cell] && keys[cell] >= 0) found.push_back(grid.fill(cell, seen));
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  GridAreas result;
  result.area_of.assign(keys.size(), -1);
  for (const std::vector<std::size_t>& cells : found) {
    for (const std::size_t cell : cells)
      result.area_of[cell] = static_cast<int>(result.areas.size());
    result.areas.push_back({keys[cells.front()], cells.size(), grid.innermost(cells)});
  }
  return result;
}

}  // namespace graze
