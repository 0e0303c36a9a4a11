// The result of a map of attractors with what made it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/record/records.hpp"
#include "graze/study/plane/detail/attractor_map.hpp"

namespace graze {

// What a picture of a map shows of its cells.
enum class MapQuantity {
  kAttractor,
  kImpacts,   // a forcing period
  kExponent,  // the largest, 1/s
  kSpeed,     // of the fastest impact, m/s
  kStuck,     // part of the time
  kMeasured   // how large the motion is
};

struct MapRecord {
  RunInfo info;
  AttractorMap map;
  std::optional<OrbitLoci> loci;  // of special points over it, where they were asked for
  std::string x_unit, y_unit;
  MapQuantity shown = MapQuantity::kAttractor;
  std::vector<MeasuredPlace> places{};  // at which motions are measured; none unless asked for
  std::optional<Shown> measured{};      // what is shown of that
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "complete"; "budget" where computing time was spent or a motion could not be followed to its end,
// "interrupted". A start that the scene does not allow is what the cell is.
Outcome map_outcome(const AttractorMap& map);

}  // namespace graze
