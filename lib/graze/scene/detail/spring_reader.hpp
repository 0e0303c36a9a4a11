// Reads the table of a compliant stop.
#pragma once

#include <string>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// `path`: "stop.spring" or "stop.2.spring". Throws InputError at the key.
Spring read_spring(const Node& node, const std::string& path, Origins& origins);

}  // namespace graze
