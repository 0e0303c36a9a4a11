// States from which motions start, spread over what the forced motion reaches.
#pragma once

#include <cstdint>
#include <span>

#include "graze/system/system.hpp"

namespace graze {

// The static deflection under a force at a stop and a velocity of that shape, as far and as fast as
// the system's scale has it, besides the steady response where there is one; clear of the rigid
// stops where they let themselves be cleared, and no deeper in a spring than a motion as fast would
// press it: a stiff one would else hold more energy than the forcing gives in any number of
// periods. `coordinates`: of both at each stop in turn, in [-1, 1). Requires forcing and a stop.
State start_at(const System& system, std::span<const double> coordinates);

// One of these at random, the same for the same numbers on every machine: `draw` is that of a
// series by `seed`.
State random_start(const System& system, std::uint64_t seed, std::uint64_t draw);

}  // namespace graze
