// Loci of special points in the plane of two parameters: each kind in a colour and a dash of its
// own, virtual parts grey, points of codimension two as dots with their ids.
#pragma once

#include <cstddef>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/chart/chart.hpp"

namespace graze {

// Points of a locus from `first` to `last` that are all admissible, or all virtual. Where the
// classification changes both parts have the point.
struct LocusPart {
  bool is_real = true;
  std::size_t first = 0, last = 0;
};
std::vector<LocusPart> locus_parts(const OrbitLocus& locus);

// Adds the loci to a panel over these parameters.
void add_loci(const OrbitLoci& traced, ChartPanel& panel);

}  // namespace graze
