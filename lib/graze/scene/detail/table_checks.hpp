// The rules between the keys of one table, and between it and the rest of the scene. All throw
// InputError.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

// The rules of the hub's own table and of the rest of the scene with it; without a hub, that no
// other key needs one.
void check_hub(const Scene& scene);

void check_probes(const Scene& scene);

// The rules of a compliant stop. `path`: "stop.spring" or "stop.2.spring".
void check_spring(const Scene& scene, const Spring& spring, const std::string& path);

}  // namespace graze
