// Flies the motion of an orbit once more.
#pragma once

#include <functional>
#include <vector>

#include "graze/orbit/problem/detail/trajectory_segment.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Callbacks; an empty function is never called.
struct OrbitListeners {
  // The phase as it was flown, the forcing phase of its start, counted from the orbit's first
  // period, rad, and its duration, s.
  std::function<void(const ContactPhase<double>& phase, double theta, double seconds)> flight;
  // As in SegmentOptions, on rigid stops.
  std::function<void(const std::vector<ImpactShare<double>>&)> impact{};
  std::function<void(const std::vector<int>&, const Vector&)> closure{};
};

// Flies the orbit in time order, from its first impact on, or from the section of an orbit that was
// followed. Returns for each flight whether it begins at an impact.
std::vector<bool> fly_orbit(const System& system, const Orbit& orbit,
                            const OrbitListeners& listeners);

}  // namespace graze
