// The special points of what was traced, as what can be gone on from.
#pragma once

#include <optional>
#include <vector>

#include "graze/bifurcation/loci/locus_continuations.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/bifurcation/problem/special_orbit.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"

namespace graze {

// Of all branches, in their order. `system`: any of the family's.
std::vector<SpecialOrbit> special_orbits(const OrbitBranches& traced, const System& system);

// Of all loci, in their order.
std::vector<SpecialOrbit> special_orbits(const OrbitLoci& traced);

// The locus that a special point lies on, as a start of it over two parameters with these values
// there. Nothing where it has none: a point of a branch that is none of LP, PD, NS and GR, whose
// orbit sticks or begins to.
std::optional<OrbitLocusStart> locus_start(const System& system, const SpecialOrbit& special,
                                           double first, double second);

}  // namespace graze
