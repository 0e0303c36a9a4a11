// States from which motions start at random.
#pragma once

#include <cstdint>

#include "graze/system/system.hpp"

namespace graze {

// The static deflection under a force at a stop and a velocity of that shape, as far and as fast as
// the system's scale has it, besides the steady response where there is one; clear of the stops
// where they let themselves be cleared. The same for the same numbers on every machine: `draw` is
// that of a series by `seed`. Requires forcing and a stop.
State random_start(const System& system, std::uint64_t seed, std::uint64_t draw);

}  // namespace graze
