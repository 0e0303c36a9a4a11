// Branches with enough points for a smooth curve of a quantity.
#pragma once

#include <functional>
#include <optional>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/trace/orbit_branches_values.hpp"

namespace graze {

// The quantity of an orbit that is drawn at a value of the parameter; nullopt when it has none.
using ShownNumber = std::function<std::optional<double>(double value, const Orbit& orbit)>;

// As trace_orbits(family, options), with points added until the curve of `shown` is accurate to a
// pixel; none are added if `shown` is empty.
OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options,
                           const ShownNumber& shown);

}  // namespace graze
