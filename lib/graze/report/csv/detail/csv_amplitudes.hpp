// How large motions are, as columns of a table: of every place, then of every stop.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"

namespace graze {

// Each with a comma before it; none without places.
std::string amplitude_columns(const std::vector<MeasuredPlace>& places);
// Empty cells where nothing was measured.
std::string amplitude_cells(const std::vector<MeasuredPlace>& places, const Amplitudes* measured);

}  // namespace graze
