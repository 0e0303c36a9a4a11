// Boundaries among the places of a traced locus: merges the places of one grazing.
#pragma once

#include <array>
#include <vector>

#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/continuation/locus/locus_values.hpp"

namespace graze {

// Distance in ranges of the parameters.
double distance(const OrbitLocusPoint& a, const OrbitLocusPoint& b, const LocusOptions& options);

// Lets a locus of folds, doublings or tori that creeps up to a grazing end on it. `unit`: of
// speeds, m/s.
void end_on_grazing(std::vector<LocusPlace>& places, std::array<OrbitLocusEnd, 2> ends,
                    double unit);

// Where an impact speed vanishes an approach touches, too: one grazing, not two. A locus that was
// started there has it among its points as well, on either side of the last bit. `unit`: of speeds,
// m/s.
void merge_boundaries(std::vector<LocusPlace>& places, const LocusOptions& options, double unit);

}  // namespace graze
