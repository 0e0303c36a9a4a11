// Whether the loci of an orbit explain where it is stable: between two places side by side, at one
// of which it is and at the other not, one of them has to pass. The two are found in different
// ways, so that a locus which nothing led to shows.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {

struct RegionBoundaries {
  int count = 0;  // pairs of places side by side
  // Those that no locus passes between, by the places' indices.
  std::vector<std::pair<std::size_t, std::size_t>> open;
};

// Of the regions of the (p, k) orbits asked for. `traced`: loci of all kinds, of which parts that
// are orbits of the system count.
RegionBoundaries region_boundaries(const StableRegions& regions, const OrbitLoci& traced);

}  // namespace graze
