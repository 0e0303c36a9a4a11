// The flights of an orbit, flown once more.
#pragma once

#include <functional>
#include <vector>

#include "graze/orbit/problem/detail/trajectory_segment.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Who wants to hear of it; an empty function is never called.
struct OrbitListeners {
  // The phase as it was flown, at which forcing phase it began, counted from the orbit's first
  // period, rad, and how long it was, s.
  std::function<void(const ContactPhase<double>& phase, double theta, double seconds)> flight;
  // As of SegmentOptions, on rigid stops.
  std::function<void(const std::vector<ImpactShare<double>>&)> impact{};
  std::function<void(const std::vector<int>&, const Vector&)> closure{};
};

// In time order: from the first impact on; of an orbit that was followed from its section on.
// Whether each flight begins at an impact.
std::vector<bool> fly_orbit(const System& system, const Orbit& orbit,
                            const OrbitListeners& listeners);

}  // namespace graze
