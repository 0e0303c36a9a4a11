// The states of an orbit once a forcing period, as a stroboscopic diagram shows them.
#pragma once

#include <vector>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// The states of an orbit at the starts of its p forcing periods (t = 0, T, ..), in time order. An
// orbit whose impact falls on such an instant is seen just after it. Requires an impact, or an
// orbit that sticks or is on compliant stops.
std::vector<State> stroboscopic_states(const System& system, const Orbit& orbit);

}  // namespace graze
