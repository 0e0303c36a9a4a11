// Characteristic sizes of a motion of the system, for relative tolerances.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// How far the force of any one mode moves the structure along the row of a stop, m; 0 without
// forcing.
double forced_reach_at(const System& system, const Vector& row);

// Length at a stop, m: the larger of forced_reach_at and the gap.
double reach_at(const System& system, const Stop& stop);

// Units of the forced motion.
struct MotionScale {
  double length = 1.0;  // m: the largest of the gaps and of what forcing and dry friction move
  double speed = 1.0;         // m/s: that times the forcing frequency
  double displacement = 1.0;  // kg^1/2 m: the length as a modal displacement
  // kg^1/2 m/s, N: for each mode the displacement times the faster of mode and forcing. In units of
  // its own the free flow of a mode only rotates and shrinks; with one unit for all modes the
  // rounding of the fast ones would hide every residual.
  Vector velocity;
};

// Requires forcing.
MotionScale motion_scale(const System& system);

// An impact speed below this, m/s, is not known to differ from zero: it is within the rounding of
// the forced velocities, whose difference it is. Requires forcing.
double still_speed(const System& system);

// A gap nearer to zero than this, m, is not known to differ from it. Requires forcing.
double still_gap(const System& system);

// Speed at the stops, m/s, the largest of: what the forcing gives over the distance to the stop
// (from rest or from the start, whichever is more) before it reverses, the fall over that distance
// under a constant load, and the initial speed. Where there is no distance, the forced motion
// without stops gives it: forced reach times forcing frequency.
double speed_scale(const System& system, const State& start);

// Longest flight without a cut, s: a number of periods of the slowest oscillation (or of the
// slowest decay, for a free mass), for systems without a forcing period or with a long one. It
// keeps a search within its budget of evaluations and the rounding of the phase small. Infinite
// where nothing oscillates or decays.
double longest_flight(const System& system);

}  // namespace graze
