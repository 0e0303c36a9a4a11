// The special points of traced branches and loci as restart points.
#pragma once

#include <optional>
#include <vector>

#include "graze/bifurcation/loci/locus_continuations.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/bifurcation/problem/special_orbit.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"

namespace graze {

// Those of all branches, in their order. `system`: any of the family's.
std::vector<SpecialOrbit> special_orbits(const OrbitBranches& traced, const System& system);

// Those of all loci, in their order.
std::vector<SpecialOrbit> special_orbits(const OrbitLoci& traced);

// Any orbit, to start from; `value`: of the parameter of its branch, nullopt of one that was found by
// itself.
SpecialOrbit orbit_to_start_from(const Orbit& orbit, const std::string& id,
                                 std::optional<double> value);

// A start of the locus that a special point lies on, over two parameters with these values there.
// Returns nullopt when it has none: a point of a branch that is not LP, PD, NS or GR, or whose
// orbit sticks or begins to.
std::optional<OrbitLocusStart> locus_start(const System& system, const SpecialOrbit& special,
                                           double first, double second);

}  // namespace graze
