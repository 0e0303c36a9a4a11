// The rules for a compliant stop.
#pragma once

#include <string>

#include "graze/scene/scene.hpp"

namespace graze {

// `path`: "stop.spring" or "stop.2.spring". Throws InputError.
void check_spring(const Scene& scene, const Spring& spring, const std::string& path);

}  // namespace graze
