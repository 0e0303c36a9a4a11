// Reads the tables of probes.
#pragma once

#include <vector>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// `node`: the list of [[probe]]; `modal`: of a [modal] structure. Throws InputError at the key.
std::vector<Probe> read_probes(const Node& node, bool modal, Origins& origins);

}  // namespace graze
