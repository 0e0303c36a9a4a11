// The rules for probes.
#pragma once

#include "graze/scene/scene.hpp"

namespace graze {

// Throws InputError.
void check_probes(const Scene& scene);

}  // namespace graze
