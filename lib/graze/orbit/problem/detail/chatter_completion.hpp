// Distance of the motion of an orbit from one whose chatter completes at the very instant at which
// its stop is released (CH).
//
// The push a s on a stop that is about to be released falls to zero linearly with the time s left.
// The chatter that just completes there is similar to itself: with restitution r its impacts, s
// before the release, have the speeds
//
//   v = w a s^2,   w = ((1 - lambda)/2 - (1 - lambda)^2/6)/r,
//   r = lambda^2 (2 + lambda)/(1 + 2 lambda),
//
// and follow one another in the ratio lambda of their times s, as the flight from speed r v to
// speed v lambda^2 under that push shows. A motion at the distance d deviates from it as
//
//   v/(w a s^2) - 1 = c s + d s^(-k),   k = ln(r^2/lambda^5)/ln(1/lambda),
//
// c from other changes of the push; two impacts give d without c, and a weighted sum of those
// around one time gives it smoothly. d goes through zero, whereas the stuck phase lasts for d^(1/k)
// on one side and does not exist on the other.
//
// With r = 0 the one impact that closes the stop comes at the release.
#pragma once

#include <optional>

#include "graze/orbit/problem/detail/segment_shooting.hpp"

namespace graze {

// lambda; 0 <= r < 1.
double completing_ratio(double restitution);
// r^2/lambda^5, the factor by which the deviation from the chatter that just completes grows from
// impact to impact; NaN where r = 0.
double parting_ratio(double restitution);

// d, in units of the longest time constant that the forcing leaves, 1/Omega; for a motion from a
// release, on the stop that is released. Requires a layout with one section there. Smooth; returns
// nullopt when the motion cannot be followed, or no chatter leads to that release.
std::optional<double> completion_distance(const System& system, const SegmentShooting& shooting,
                                          const Vector& u);

}  // namespace graze
