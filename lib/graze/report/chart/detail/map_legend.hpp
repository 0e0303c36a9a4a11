// The kinds of the cells of a map by their settled motion, and their entries in the legend: motions
// that always look alike have their ground (appearance/looks.hpp), the others with the most cells
// get one each.
#pragma once

#include <string>
#include <vector>

#include "graze/record/study_records.hpp"
#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/detail/chart_cells.hpp"

namespace graze {

struct MapLegend {
  struct Entry {
    std::string name, colour;  // "#0072B2"
  };
  struct Kind {
    std::string name;
    std::size_t entry = 0;
  };
  std::vector<Entry> entries;
  std::vector<Kind> kinds;   // the attractors in their order, then what cells without one are
  std::vector<int> kind_of;  // of every cell; -1: it was not run
};

// The ground of all motions of a kind in every map; null for one that depends on the number of
// cells.
const Look* ground_of(const AttractorClass& attractor);

MapLegend map_legend(const AttractorMap& map);
// By the attractors of both motions of a cell, or that they differ.
MapLegend comparison_legend(const ComparisonMap& map);

void set_grounds(const MapLegend& legend, ChartCells& cells);

// The cells as things of a chart for a page, which shows them by the kinds of the legend, together
// called `name`, or by any of the numbers. `shown`: the key of the one shown first, or another
// word.
ChartThings explored_cells(const MapLegend& legend, const std::string& name,
                           const std::vector<CellNumbers>& numbers, const std::string& shown,
                           ChartCells& cells);

// How what is shown of the cells, other than by kind, becomes colours.
CellScale scale_of(MapQuantity quantity);

}  // namespace graze
