// How the options of a range of a parameter reach the tracing of branches.
#pragma once

#include "command.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"

namespace graze {

// Throws InputError for a range or a step that cannot be used.
BranchOptions branch_options(const Command& command);

}  // namespace graze
