// When two orbits are one, and when one orbit is several rounds of a shorter one.
#pragma once

#include <optional>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Phases nearer than this, rad, and speeds nearer than this part of the largest are the same:
// solutions are accurate to about the square root of eps even next to a fold, where they are least
// well determined.
inline constexpr double kSameOrbit = 1e-7;

// Whether two orbits are one: same pattern, phases and speeds within the accuracy of a solution.
// `speed_scale`, m/s: that of the forced motion, from which impact speeds are left over.
bool same_orbit(const Orbit& a, const Orbit& b, double speed_scale);

// The shortest pattern that an orbit repeats within itself; nothing when it is minimal.
std::optional<ImpactPattern> repeated_pattern(const Orbit& orbit);

// An order of orbits in which no two different ones tie: by period, number of impacts, phases,
// stops, forcing periods of the impacts, speeds.
bool comes_before(const Orbit& a, const Orbit& b);

}  // namespace graze
