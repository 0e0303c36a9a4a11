// Whether the loci of an orbit explain where it is stable: a locus has to pass between two
// neighbouring places if it is stable at one of them only. Loci and stability are computed in
// different ways, so that a missed locus shows.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {

struct RegionBoundaries {
  int count = 0;  // pairs of places side by side
  // Neighbours, by the places' indices, without a locus between them.
  std::vector<std::pair<std::size_t, std::size_t>> open;
};

// For the regions of the requested (p, k) orbits. `traced`: loci of all kinds, of which the
// admissible parts count.
RegionBoundaries region_boundaries(const StableRegions& regions, const OrbitLoci& traced);

}  // namespace graze
