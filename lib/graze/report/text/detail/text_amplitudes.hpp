// Private to this room. How large motions are, at places and at stops.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"

namespace graze {

// Of one motion, or of several that are numbered under this heading ("orbit"); empty where nothing
// was measured.
std::string amplitudes_text(const std::vector<MeasuredPlace>& places,
                            const std::vector<Amplitudes>& measured, const std::string& numbered);

}  // namespace graze
