// How large the motion of an orbit is: what response curves show of it.
#pragma once

#include <vector>

#include "graze/motion/amplitudes.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Over its period, at these rows and at every stop.
Amplitudes orbit_amplitudes(const System& system, const Orbit& orbit,
                            const std::vector<MeasuredRow>& rows);

}  // namespace graze
