// The differences of two scenes that matter to an orbit.
#pragma once

#include <string>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// A sentence about the first difference between `there` and `here`, or "". Not compared are the
// `free` parameters and what no orbit depends on: the title, the initial state and the solver.
std::string scene_difference(Scene there, Scene here, const std::vector<std::string>& free);

}  // namespace graze
