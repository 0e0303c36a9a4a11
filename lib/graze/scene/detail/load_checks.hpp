// Rules between the keys of loads, and of stops that move with them (check.hpp).
#pragma once

#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

// Of constant forces, of the forcing, and of the motion of a stop at the path `table`. They throw
// InputError.
void check_loads(const Scene& scene);
void check_frictions(const Scene& scene);
void check_forcing(const Scene& scene);
void check_motion(const Scene& scene, const SceneStop& stop, const std::string& table);

}  // namespace graze
