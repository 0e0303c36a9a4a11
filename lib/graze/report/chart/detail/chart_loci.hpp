// Loci of special points in the plane of two parameters: each kind in a colour and a dash of its
// own, parts whose orbits are none of the system grey, points of codimension two as dots with their
// ids.
#pragma once

#include <cstddef>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/chart/chart.hpp"

namespace graze {

// Points of a locus from `first` to `last` whose orbits all are, or are not, some of the system.
// Where the classification changes both parts have the point.
struct LocusPart {
  bool is_real = true;
  std::size_t first = 0, last = 0;
};
std::vector<LocusPart> locus_parts(const OrbitLocus& locus);

// "CP-1: cusp, on locus 2 (LP)"
std::string special_title(const OrbitLocus& locus, const OrbitLocusSpecial& special);

// Into a panel over these parameters. `things`: points of codimension two are added to them; or
// null.
void add_loci(const OrbitLoci& traced, ChartPanel& panel, ChartThings* things = nullptr);

}  // namespace graze
