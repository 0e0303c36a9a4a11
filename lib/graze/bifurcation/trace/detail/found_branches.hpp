// Branches of orbits as found, and as returned: in an order and under names that do not depend on
// which start found them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "graze/bifurcation/trace/detail/branch_parts.hpp"
#include "graze/bifurcation/trace/detail/components.hpp"

namespace graze {

// A part of a trace that is listed.
struct FoundBranch {
  BranchPart part;
  int trace = 0;                   // its number
  int origin_branch = -1;          // index of the found branch from which it was switched onto
  std::size_t origin_special = 0;  // and of the special point there

  OrbitBranch& branch() { return part.branch; }
  const OrbitBranch& branch() const { return part.branch; }
};

// A name for the connected set of solutions that a branch belongs to; nullopt when it is not known.
using ConnectedSet = std::function<std::optional<std::pair<int, int>>(const OrbitBranch&)>;

// The branches sorted by period, impacts and lowest parameter value, those that stick last;
// numbered, with names of their special points and components, and with their origins.
// `components`: still empty. `set_of`: its names are not negative.
std::vector<OrbitBranch> put_in_order(std::vector<FoundBranch> found, Components components,
                                      const ConnectedSet& set_of);

}  // namespace graze
