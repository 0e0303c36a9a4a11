// Regions of stable motions in a plane of two parameters, as grounds of cells.
#pragma once

#include <vector>

#include "graze/report/chart/chart.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {

struct RegionTints {
  std::vector<ChartCells::Ground> grounds;  // all that there may be
  std::vector<int> of;                      // of every place; -1: none
};
RegionTints region_tints(const StableRegions& regions);

// The places as the cells of a panel, whose axes span the plane, and the names of its areas.
void add_tints(const StableRegions& regions, ChartPanel& panel);

}  // namespace graze
