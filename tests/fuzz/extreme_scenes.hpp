// Scenes at the far ends of what is allowed: many modes and stops, resonance, numbers of any order
// of magnitude. A program that asks the clock after so many rounds of a loop, and not after so much
// work, is found out by them.
#pragma once

#include <string>
#include <vector>

#include "fuzz/draw.hpp"

namespace graze {

std::string extreme_scene(Draw& draw);

// Words of a command on it, without a bound on its time.
std::vector<std::string> extreme_command(const std::string& scene, Draw& draw);

}  // namespace graze
