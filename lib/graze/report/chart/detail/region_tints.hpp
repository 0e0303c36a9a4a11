// Regions of stable motions in a plane of two parameters, as grounds of cells.
#pragma once

#include "graze/report/chart/detail/map_legend.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {

// Kinds are what is stable; their colours are the tints.
MapLegend region_legend(const StableRegions& regions);

// The places as the cells of a panel, whose axes span the plane, and the names of its areas.
void add_tints(const StableRegions& regions, ChartPanel& panel);

}  // namespace graze
