// Private to this room. Loci in the plane of two parameters.
#pragma once

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

Json loci_json(const OrbitLoci& traced);
// How they were found.
Json loci_counters_json(const OrbitLoci& traced);

}  // namespace graze
