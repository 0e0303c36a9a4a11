// The impacts of a periodic motion in one period, in time order.
#pragma once

#include <cstddef>
#include <vector>

#include "graze/system/system.hpp"

namespace graze {

struct ImpactPattern {
  int period = 1;          // p
  std::vector<int> stops;  // the stop of each impact, in time order (index from 0)

  int impacts() const { return static_cast<int>(stops.size()); }
  bool operator==(const ImpactPattern&) const = default;
};

// One impact: the state of the motion just before it.
struct ImpactPoint {
  double theta = 0.0;  // forcing phase, rad, not reduced
  State before;
};

// The stop of impact i of a pattern.
const Stop& stop_of(const System& system, const ImpactPattern& pattern, std::size_t i);

// Seconds from impact i to the next one.
double flight_time(const System& system, const ImpactPattern& pattern,
                   const std::vector<ImpactPoint>& points, std::size_t i);

}  // namespace graze
