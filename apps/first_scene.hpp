// Scenes to begin with, each a whole file with comments.
#pragma once

#include <string>
#include <vector>

namespace graze {

// beam, oscillator, matrices, hub.
std::vector<std::string> first_scene_kinds();

// Of one of them. That of matrices names files in this folder; the others do without.
std::string first_scene(const std::string& kind, const std::string& matrices_folder);

}  // namespace graze
