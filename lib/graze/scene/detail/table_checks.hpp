// The rules between the keys of one table, and between it and the rest of the scene. All throw
// InputError.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

// What a hub asks of its own table and of the rest of the scene; without one, that nothing there
// needs it.
void check_hub(const Scene& scene);

void check_probes(const Scene& scene);

// Of a compliant stop. `path`: "stop.spring" or "stop.2.spring".
void check_spring(const Scene& scene, const Spring& spring, const std::string& path);

}  // namespace graze
