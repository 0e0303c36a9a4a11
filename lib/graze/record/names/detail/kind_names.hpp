// The words of results for kinds and ends.
#pragma once

#include <optional>
#include <string>

#include "graze/bifurcation/problem/orbit_locus.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"

namespace graze {

std::string name_of(EventKind kind);
std::string name_of(OrbitBranchEnd end);
std::string name_of(OrbitLocusEnd end);

// "yes", "no", or "on the circle" for a stability that rounding leaves open.
std::string stability_word(const std::optional<bool>& stable);

}  // namespace graze
