// The orbit that a repeating motion is near, and the remaining distance from it.
//
// Differences between repetitions do not show this distance: where a fast part of the deviation
// hides a slow one they are small long before the motion is near. The shooting equations show it.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

struct NearbyOrbit {
  ImpactPattern pattern;
  std::vector<ImpactPoint> points;  // in the order of the motion that led to it
  std::optional<bool> stable;       // nullopt when a multiplier lies on the unit circle
};

// Newton's method from points of the motion. Returns nullopt when it does not converge to a
// solution within 1e-3 of them, or when there are so many unknowns that solving for them would cost
// more than running on.
std::optional<NearbyOrbit> nearby_orbit(const System& system, const ImpactPattern& pattern,
                                        const std::vector<ImpactPoint>& points);

// Largest distance of points of a motion from the orbit's: of phases (rad), relative speeds, and
// states in units of `scale`. Infinite when their numbers differ.
double distance(const System& system, const MotionScale& scale, const NearbyOrbit& orbit,
                const std::vector<ImpactPoint>& points);

// The smallest number of forcing periods after which the orbit repeats itself, phases (rad) and
// relative speeds within `tolerance`.
int shortest_period(const System& system, const NearbyOrbit& orbit, double tolerance);

}  // namespace graze
