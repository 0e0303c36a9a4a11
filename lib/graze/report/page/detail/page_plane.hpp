// A plane of two numbers as a page shows it: its axes, what its cells are, and the loci over them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/chart/detail/map_legend.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/scene/scene.hpp"
#include "graze/study/plane/plane.hpp"

namespace graze {

// An axis with the values at the middles of its cells.
Json plane_axis_json(const PlaneAxis& axis, const std::string& unit);
// Without cells: what it spans, SI.
Json plane_axis_json(const std::string& parameter, const std::string& unit, AxisRange range);

// What the cells are called together ("attractor"), their kinds and the sentences of those that
// have something to say. `is_wild`: of kinds that never repeat; empty: none does.
struct PlaneCells {
  std::string name;
  MapLegend legend;
  std::function<const std::string&(std::size_t cell)> message;
  std::vector<bool> is_wild = {};
};
Json cells_json(const PlaneCells& cells);

// A number of every cell, NaN where it has none, on a scale of colours.
struct PlaneNumber {
  std::string key, name, unit;  // SI
  CellScale scale = CellScale::kFromZero;
  std::function<double(std::size_t cell)> of;
};
Json number_json(const PlaneNumber& number, std::size_t cells);

// The lines of all loci, by kind, and the points of codimension two; null without any.
Json loci_json(const OrbitLoci* traced);

// A command that follows what a cell does: what stands before and after the settings of the cell,
// and the start that its coordinates replace numbers of.
Json cell_command_json(const std::string& before, const std::string& after, const Plane& plane,
                       const Scene& scene);

}  // namespace graze
