// How the options of a range of a parameter reach the tracing of branches.
#pragma once

#include "command.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/bifurcation/trace/shown_branches.hpp"

namespace graze {

// Throws InputError for a range or a step that cannot be used.
BranchOptions branch_options(const BranchingOptions& command);

// What a picture shows in place of impact speeds; throws InputError where there is no such place.
std::optional<Shown> shown_of(std::optional<ShownQuantity> quantity, const std::string& at,
                              const std::vector<MeasuredPlace>& places);
// That number of an orbit in the family, which has to outlive it; empty where none is shown.
ShownNumber number_of(const std::optional<Shown>& shown, const SystemFamily& family);

}  // namespace graze
