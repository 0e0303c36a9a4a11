// Where a scene's motion starts.
#pragma once

#include <optional>

#include "graze/scene/scene.hpp"
#include "graze/system/system.hpp"

namespace graze {

// The state at t = 0: as the scene says, else at rest; undeformed, but pressed against its stops in
// static equilibrium where one of them is preloaded (negative gap). Throws InputError, with the
// penetration, when it lies beyond a stop by more than the rounding of row.q.
State initial_state(const Scene& scene, const System& system);

// The same, but returns nullopt when the motion cannot start there.
std::optional<State> clear_start(const Scene& scene, const System& system);

}  // namespace graze
