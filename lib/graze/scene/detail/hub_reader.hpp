// Reads the table of a rotating hub.
#pragma once

#include <filesystem>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// `folder`: of the scene's file, which names of other files start from; empty: the current one.
// Throws InputError at the key, FileError for a file that cannot be read.
Hub read_hub(const Node& node, const std::filesystem::path& folder, Origins& origins);

}  // namespace graze
