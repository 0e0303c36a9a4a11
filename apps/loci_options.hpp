// How the options of loci reach what traces them.
#pragma once

#include "command.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"

namespace graze {

// Throws InputError where the second parameter or its range is missing, or a range reaches beyond
// what the scene allows.
LociOptions loci_options(const LocusTracingOptions& command, const Scene& scene);

}  // namespace graze
