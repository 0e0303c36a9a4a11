// Sizes that a motion of the system has, for tolerances that have to be relative to something.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// Length at a stop, m: the gap, or how far one mode's force moves it if that is more.
double reach_at(const System& system, const RigidStop& stop);

// Speed at the stops, m/s: reach times forcing frequency, the fall through the reach under a
// constant load, and what the start brings along, whichever is largest.
double speed_scale(const System& system, const State& start);

}  // namespace graze
