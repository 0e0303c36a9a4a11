// Sizes that a motion of the system has, for tolerances that have to be relative to something.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// How far the force of any one mode moves the structure at a stop, m; 0 without forcing.
double forced_reach_at(const System& system, const RigidStop& stop);

// Length at a stop, m: that, or the gap if it is more.
double reach_at(const System& system, const RigidStop& stop);

// Speed at the stops, m/s: forced reach times forcing frequency, the fall through the reach under a
// constant load, and what the start brings along, whichever is largest.
double speed_scale(const System& system, const State& start);

// Without forcing nothing divides time: flights are cut after a number of the slowest oscillations
// (or decays, of a free mass), so that a search neither runs out of its evaluations nor lets the
// phase's rounding grow, s. Infinite where nothing oscillates or decays.
double longest_free_flight(const System& system);

}  // namespace graze
