// Loci of special points in the plane of two parameters: each kind in a colour and a dash of its
// own, virtual parts grey, points of codimension two as dots with their ids.
#pragma once

#include <string>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/chart/chart.hpp"

namespace graze {

// "CP-1: cusp, on locus 2 (LP)"
std::string special_title(const OrbitLocus& locus, const OrbitLocusSpecial& special);

// Into a panel over these parameters. `things`: points of codimension two are added to them; or
// null.
void add_loci(const OrbitLoci& traced, ChartPanel& panel, ChartThings* things = nullptr);

}  // namespace graze
