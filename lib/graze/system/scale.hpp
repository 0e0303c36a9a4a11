// Sizes that a motion of the system has, for tolerances that have to be relative to something.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// How far the force of any one mode moves the structure at a stop, m; 0 without forcing.
double forced_reach_at(const System& system, const Stop& stop);

// Length at a stop, m: that, or the gap if it is more.
double reach_at(const System& system, const Stop& stop);

// Units of the forced motion.
struct MotionScale {
  double length = 1.0;        // m: the larger of the gaps and of what the forcing moves at a stop
  double speed = 1.0;         // m/s: that times the forcing frequency
  double displacement = 1.0;  // kg^1/2 m: the length as a modal displacement
  // kg^1/2 m/s, N: of each mode the displacement times the faster of mode and forcing. In units of
  // its own the free flow of a mode only turns and shrinks; in one for all the rounding of the fast
  // ones would drown every residual.
  Vector velocity;
};

// Requires forcing.
MotionScale motion_scale(const System& system);

// An impact speed below this, m/s, is within the rounding of the forced velocities that it is left
// over from; it is not known to differ from zero. Requires forcing.
double still_speed(const System& system);

// A gap nearer to zero than this, m, is not known to differ from it. Requires forcing.
double still_gap(const System& system);

// Speed at the stops, m/s: what the forcing gives over the distance to the stop (of rest or of the
// start, whichever is more) before it turns, the fall over that distance under a constant load, and
// what the start brings along, whichever is largest. Where there is no distance, the forced motion
// without stops gives it: forced reach times forcing frequency.
double speed_scale(const System& system, const State& start);

// Where no forcing period divides time, or a long one does, flights are cut after a number of the
// slowest oscillations (or decays, of a free mass), so that a search neither runs out of its
// evaluations nor lets the phase's rounding grow, s. Infinite where nothing oscillates or decays.
double longest_flight(const System& system);

}  // namespace graze
