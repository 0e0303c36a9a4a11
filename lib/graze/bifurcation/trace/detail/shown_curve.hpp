// Adds points between those of a traced branch until the drawn curve is accurate to a pixel: steps
// follow the unknowns, which may vary little where the drawn quantity varies much.
#pragma once

#include "graze/bifurcation/trace/detail/branch_pieces.hpp"
#include "graze/bifurcation/trace/shown_branches.hpp"

namespace graze {

// `branch` is one of these orbits, traced with these options. Stops when their signal is given.
void resolve_shown(const LaidOrbits& orbits, const ContinuationOptions& options,
                   const OrbitNumber& shown, Branch& branch);

}  // namespace graze
