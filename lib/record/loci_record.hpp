// The result of tracing loci in two parameters.
#pragma once

#include <string>
#include <vector>

#include "graze/bifurcation/orbit_loci.hpp"
#include "graze/record/records.hpp"

namespace graze {

struct LociRecord {
  RunInfo info;
  OrbitLoci traced;
  double from = 0.0, to = 0.0, second_from = 0.0, second_to = 0.0;
  std::string unit, second_unit;  // of the parameters
  std::vector<std::string> warnings;
  Outcome outcome;
};

Outcome loci_outcome(const OrbitLoci& traced, const LociOptions& options);

}  // namespace graze
