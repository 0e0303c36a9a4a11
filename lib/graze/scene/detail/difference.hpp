// What an orbit depends on that two scenes do not share.
#pragma once

#include <string>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// A sentence about the first thing in which `there` and `here` differ, but for the `free`
// parameters and what an orbit does not depend on: the title, the initial state and the solver. ""
// where they do not differ.
std::string scene_difference(Scene there, Scene here, const std::vector<std::string>& free);

}  // namespace graze
