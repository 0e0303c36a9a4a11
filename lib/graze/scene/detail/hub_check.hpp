// The rules for a rotating hub.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// What a hub asks of its own table and of the rest of the scene; without one, that nothing there
// needs it. Throws InputError.
void check_hub(const Scene& scene);

}  // namespace graze
