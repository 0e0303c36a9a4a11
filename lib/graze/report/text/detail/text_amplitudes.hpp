// Private to this room. Amplitudes of a motion, at places and at stops.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/report/text/text.hpp"

namespace graze {

// Two tables.
std::string amplitudes_text(const std::vector<MeasuredPlace>& places, const Amplitudes& measured,
                            Units units, const TextOptions& options);

}  // namespace graze
