// Conditions for a solution of the shooting equations to be an orbit, as quantities that must stay
// positive, each with its rate along a branch of solutions: the speed of every impact, and the gap
// at every interior approach to a stop.
//
// Both are smooth along the branch. An approach is where the gap's rate g' vanishes, so that moving
// it in time does not change the gap to first order: its rate is that of the gap at a fixed time,
// and the approach itself moves by -(rate of g')/g''.
#pragma once

#include <cstddef>
#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// Derivative of a solution along a branch: rates of its unknowns and of the system, per unit of
// arclength.
struct OrbitDirection {
  std::vector<ImpactPoint> impacts;  // rates of phase and state
  double parameter = 0.0;            // rate of the parameter
  const System* tangent = nullptr;   // derivative of the system by the parameter
};

struct OrbitMargin {
  std::size_t impact = 0;  // the impact of the speed, or before the flight
  int stop = 0;            // the stop that is hit or approached, index from 0
  bool is_speed = false;
  double value = 0.0, rate = 0.0;  // m or m/s; per unit of arclength
  // For an approach: forcing phase from the impact to it, rad, and its rate.
  double after = 0.0, after_rate = 0.0;
};

// The speeds, in the order of the impacts.
std::vector<OrbitMargin> speed_margins(const System& system, const ImpactPattern& pattern,
                                       const std::vector<ImpactPoint>& points,
                                       const OrbitDirection& direction);

// The approaches with a gap below `level`, m, flight by flight. The minimum beyond the stop that an
// impact at negative speed ends or begins with is left out: it follows from that speed. A gap of
// minus infinity means that the search could not be finished.
std::vector<OrbitMargin> approach_margins(const System& system, const ImpactPattern& pattern,
                                          const std::vector<ImpactPoint>& points,
                                          const OrbitDirection& direction, double level);

// About how fast any gap changes, m per unit of arclength: sum |b_j| times the amplitude of the
// deviation of mode j, at the ends of the flights.
double gap_drift(const System& system, const ImpactPattern& pattern,
                 const std::vector<ImpactPoint>& points, const OrbitDirection& direction);

}  // namespace graze
