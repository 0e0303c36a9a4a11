// Where the stuck phases of an orbit change: CH, where one of them shrinks to nothing or is cut in
// two, and LO, where the only one has grown to the whole period: beyond, the structure stays
// pressed on the stop.
//
// CH is where the motion stops coming to rest, and it is located by that: between an orbit that
// sticks and a solution that does not, to the last digits of arclength. A chatter is summed only
// where the push outlasts it by far, whatever the closure speed; nearer to CH it is followed impact
// by impact. So CH does not depend on how chatters are closed. The duration of the stuck phase is
// nearly proportional to the distance to CH to the power 3/5: where the push falls to zero linearly
// at the release, a chatter that just completes shrinks by about r^(3/5) in time from impact to
// impact, and its distance from one that does not grows by about 1/r. Where a contact force touches
// zero the stop is open for a time proportional to the square root of the distance. Both are
// followed to 1e-10 of the parameter.
#pragma once

#include <optional>
#include <utility>

#include "graze/bifurcation/cut/detail/release_approach.hpp"
#include "graze/bifurcation/cut/detail/release_tip.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

// The CH or LO at the boundary that was approached; none when the boundary is something else, or
// cannot be classified to the last digits.
ReleaseTip completion(const SegmentEquations& equations, const ReleaseApproach& approach);

// Where the force that holds the structure at rest touches zero, as the value of the parameter and
// the phase, rad. Flights near that are too short to be detected; the force is smooth across it.
// The tip is known to their resolution; returns nullopt when the force does not vanish there.
// `range`: of the parameter.
std::optional<std::pair<double, double>> lift_off(const SegmentEquations& equations, double range,
                                                  const ReleaseTip& tip);

}  // namespace graze
