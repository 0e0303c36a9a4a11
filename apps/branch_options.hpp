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
// The levels that are asked for; `at`: the place of those that name none. Throws InputError.
std::vector<OrbitLevel> levels_of(const LevelOptions& options, const std::string& at,
                                  const Scene& scene);
// That number of an orbit; empty where none is shown.
OrbitNumber number_shown(const std::optional<Shown>& shown);

}  // namespace graze
