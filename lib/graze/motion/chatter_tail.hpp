// The tail of a chatter that was summed, until it is over.
#pragma once

#include <algorithm>
#include <vector>

#include "graze/flow/exact/instant.hpp"

namespace graze {

// The tail of a chatter that was summed: the motion is at rest on its stops from the instant of the
// summation, but events report this only when the tail is over.
struct ChatterTail {
  std::vector<int> stops;  // ascending
  Instant<double> over;
  bool holds(int stop) const { return std::binary_search(stops.begin(), stops.end(), stop); }
};

}  // namespace graze
