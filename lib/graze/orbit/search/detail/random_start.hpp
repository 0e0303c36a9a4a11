// Start states of motions: spread over the range of the forced motion, clear of every rigid stop.
#pragma once

#include <cstdint>
#include <span>

#include "graze/system/system.hpp"

namespace graze {

// Stops and frictions.
inline std::size_t places_of_starts(const System& system) {
  return system.stops.size() + system.frictions.size();
}

// The static deflection under a force at a stop or a friction and a velocity of that shape, up to
// the system's scale of displacement and speed, added to the steady response where there is one. It
// is moved clear of the rigid stops where possible, and is no deeper in a spring than a motion of
// that speed would press it: in a stiff spring it would else hold more energy than the forcing
// gives in any number of periods. `coordinates`: of both at each of these in turn, in [-1, 1).
// Requires forcing and one of them.
State start_at(const System& system, std::span<const double> coordinates);

// A random one of these, the same for the same numbers on every machine: number `draw` of the
// series given by `seed`.
State random_start(const System& system, std::uint64_t seed, std::uint64_t draw);

// Whether no rigid stop is penetrated, within the rounding of the gap.
bool is_clear(const System& system, const State& state);

// Moves a state that penetrates stops back onto them, each along the direction of its impulse, the
// shortest way in units of kinetic energy. False where stops that act on one another leave it
// penetrating.
bool bring_clear(const System& system, State& state);

}  // namespace graze
