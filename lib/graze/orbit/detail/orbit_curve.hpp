// The motion of an orbit between its impacts: flown once more, or as samples of curves.
#pragma once

#include <functional>
#include <vector>

#include "graze/orbit/problem/detail/trajectory_segment.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/system/measured_row.hpp"

namespace graze {

struct CurveSample {
  double theta = 0.0;         // forcing phase counted from the orbit's first period, rad
  double displacement = 0.0;  // of the measured row, of a stop's own into the stop, m
  double velocity = 0.0;      // m/s
};

// One list for each flight from impact to impact, ends included, with at least `per_period` samples
// in a forcing period.
std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  const MeasuredRow& seen, int per_period);

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
