// When two orbits are the same, and when an orbit repeats a shorter one.
#pragma once

#include <optional>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Phases that differ by less than this, rad, and speeds by less than this part of the largest, are
// the same: solutions are accurate to about the square root of eps even next to a fold, where they
// are least well determined.
inline constexpr double kSameOrbit = 1e-7;

// Whether two orbits are the same: same pattern, phases and speeds within the accuracy of a
// solution. `speed_scale`, m/s: of the forced motion, of which impact speeds are differences.
bool same_orbit(const Orbit& a, const Orbit& b, double speed_scale);

// The shortest pattern that an orbit repeats within itself; nullopt when it is minimal.
std::optional<ImpactPattern> repeated_pattern(const Orbit& orbit);

// A total order of orbits: by period, number of impacts, phases, stops, forcing periods of the
// impacts, speeds.
bool comes_before(const Orbit& a, const Orbit& b);

}  // namespace graze
