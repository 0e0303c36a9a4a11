// Branches with points enough for a curve that is to be shown of them.
#pragma once

#include <functional>
#include <optional>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/trace/orbit_branches_values.hpp"

namespace graze {

// What is shown of an orbit at a value of the parameter; nothing where it cannot be told.
using ShownNumber = std::function<std::optional<double>(double value, const Orbit& orbit)>;

// As trace_orbits(family, options), with points added until the curve of `shown` is right to a
// pixel; where that is empty none are.
OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options,
                           const ShownNumber& shown);

}  // namespace graze
