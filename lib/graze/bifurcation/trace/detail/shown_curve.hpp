// Points between those of a traced branch, until the curve that a picture shows of it is right to a
// pixel: steps follow the unknowns, which may say little of the number that is shown.
#pragma once

#include "graze/bifurcation/trace/detail/branch_pieces.hpp"
#include "graze/bifurcation/trace/shown_branches.hpp"

namespace graze {

// Of a branch of these orbits, as traced with these options. Stops where those do.
void resolve_shown(const LaidOrbits& orbits, const ContinuationOptions& options,
                   const ShownNumber& shown, Branch& branch);

}  // namespace graze
