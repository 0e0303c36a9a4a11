// The connected areas of equal cells in a grid: cells are neighbours across an edge, not across a
// corner.
#pragma once

#include <cstddef>
#include <vector>

namespace graze {

struct GridArea {
  int key = 0;
  std::size_t cells = 0;
  // The cell with the most edges to cross to leave the area or the grid; of several the one nearest
  // to their middle.
  std::size_t innermost = 0;
};

struct GridAreas {
  std::vector<GridArea> areas;  // the largest first, equal ones by their first cell
  std::vector<int> area_of;     // of each cell, an index of `areas`; -1: none
};

// `keys` row by row, `columns` a row; cells with a negative key are part of no area.
GridAreas grid_areas(const std::vector<int>& keys, int columns);

}  // namespace graze
