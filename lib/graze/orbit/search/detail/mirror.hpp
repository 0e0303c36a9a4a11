// The symmetry of a linear structure between mirrored stops: where u(t) is a motion, so is
// -u(t + T/2), T the forcing period, with every impact on the opposite stop. Orbits come in such
// pairs unless they are their own mirror image.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/followed_orbit.hpp"

namespace graze {

// For each stop its opposite; nullopt when one has none, or a constant load breaks the symmetry.
std::optional<std::vector<int>> opposite_stops(const System& system);

// The mirror image of an orbit; nullopt when its equations cannot be solved or its motion does not
// come back to its section. `opposite` as above.
std::optional<Orbit> mirrored_orbit(const System& system, const Orbit& orbit,
                                    const std::vector<int>& opposite,
                                    const SegmentOptions& options);

}  // namespace graze
