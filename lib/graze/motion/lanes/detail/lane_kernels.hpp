// The vector kernel of motions flown side by side (Google's Highway; the widest unit of the
// processor, chosen at run time). A lane does the same operations whatever the other lanes do, and
// whatever the width of the vectors, where they have fused multiply-add.
#pragma once

#include <cstdint>

#include "graze/motion/lanes/detail/lane_columns.hpp"

namespace graze {

// Lanes by their numbers, one bit for each.
using LaneSet = std::uint32_t;

// The lanes that have arrived at an event.
struct LaneArrivals {
  LaneSet contacts = 0;  // an impact was applied; the end of its flight is in kEnd ..
  LaneSet ends = 0;      // of a forcing period
  LaneSet left = 0;      // at a rare event, to be followed elsewhere from the start of the flight
};

// Flies all lanes that are not idle until some of them arrive. Those that arrived at contacts and
// ends have started their next flight; those that left are idle.
LaneArrivals fly_lanes(LaneColumns& columns);

}  // namespace graze
