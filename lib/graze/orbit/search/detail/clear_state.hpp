// States from which a motion can start: clear of every rigid stop.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// Whether no rigid stop is penetrated, within the rounding of the gap.
bool is_clear(const System& system, const State& state);

// Moves a state that penetrates stops back onto them, each along the direction of its impulse, the
// shortest way in units of kinetic energy. False where stops that act on one another leave it
// penetrating.
bool bring_clear(const System& system, State& state);

}  // namespace graze
