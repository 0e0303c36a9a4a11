// The flights of an orbit, flown once more.
#pragma once

#include <functional>
#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// The phase as it was flown, at which forcing phase it began, counted from the orbit's first
// period, rad, and how long it was, s.
using FlightVisitor =
    std::function<void(const ContactPhase<double>& phase, double theta, double seconds)>;

struct FlownOrbit {
  std::vector<bool> begins_at_impact;       // of every flight
  std::vector<TrajectorySegment> segments;  // of an orbit that was followed
};

// In time order: from the first impact on; of an orbit that was followed from its section on.
FlownOrbit fly_orbit(const System& system, const Orbit& orbit, const FlightVisitor& visit);

}  // namespace graze
