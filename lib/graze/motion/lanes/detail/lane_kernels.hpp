// The vector kernel of motions flown side by side (Google's Highway; the widest unit of the
// processor, chosen at run time). A lane does the same operations whatever the other lanes do, and
// whatever the width of the vectors, where they have fused multiply-add.
#pragma once

#include <cstdint>

#include "graze/motion/lanes/detail/lane_columns.hpp"

namespace graze {

// Lanes by their numbers, one bit each.
using LaneSet = std::uint32_t;

// What the lanes have come to.
struct LaneArrivals {
  LaneSet contacts = 0;  // an impact was applied; the flight that it ended was told of in kEnd ..
  LaneSet ends = 0;      // of a forcing period
  LaneSet left = 0;      // at something rare, to be looked after from where the flight began
};

// Flies all lanes that are not idle until some of them arrive. Those that arrive at contacts and
// ends have set out again; those that left are idle.
LaneArrivals fly_lanes(LaneColumns& columns);

}  // namespace graze
