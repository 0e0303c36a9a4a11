// The result of tracing loci in two parameters, and of looking for what is stable between them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/record/records.hpp"
#include "graze/study/plane/detail/region_boundaries.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {

struct LociRecord {
  RunInfo info;
  OrbitLoci traced;
  std::optional<StableRegions> regions;        // where they were asked for
  std::optional<RegionBoundaries> boundaries;  // of these, where loci of all kinds were traced
  double from = 0.0, to = 0.0, second_from = 0.0, second_to = 0.0;
  std::string unit, second_unit;  // of the parameters
  std::vector<std::string> warnings;
  Outcome outcome;
};

Outcome loci_outcome(const OrbitLoci& traced, const LociOptions& options);

// How the whole ended, `loci` being the outcome of tracing them. Where regions are shown, that no
// loci were met is no failure.
Outcome regions_outcome(const StableRegions& regions, const Outcome& loci);

}  // namespace graze
