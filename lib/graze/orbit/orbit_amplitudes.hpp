// How large the motion of an orbit is, as response curves show it.
#pragma once

#include <vector>

#include "graze/motion/amplitudes.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Amplitudes over the orbit's period, at these rows and at every stop.
Amplitudes orbit_amplitudes(const System& system, const Orbit& orbit,
                            const std::vector<MeasuredRow>& rows);

}  // namespace graze
