// Periodic orbits whose motion is followed from section to section (segment_shooting.hpp): those
// that stick, or close a chatter, those on compliant stops, and those of very many impacts.
//
// The motion is certified event by event, so that a solution is admissible: gaps are clear between
// events, contact forces push while stuck. Where stops are closed the section lies within a stuck
// phase; the multipliers of held coordinates are exactly zero. With as many closed stops as modes
// there are no unknowns: any start that sticks leads to the orbit.
//
// The tail of a chatter below the closure speed v_c is summed: the accumulation time has an error
// of O(v_c^2), state and multipliers of O(v_c^3), and the impacts are the resolved ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/problem/detail/grazing_contact.hpp"
#include "graze/orbit/problem/detail/segment_shooting.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

struct FollowedAnswer {
  std::optional<Orbit> orbit;  // minimal and admissible
  std::string why_not;         // a sentence where there is none
};

// The orbit near the motion that starts at `at_period_start` (t = 0) and repeats after `period`
// forcing periods. Requires forcing. The guess has to lie where Newton's method converges; a
// simulated motion that repeats to 1e-6 does.
FollowedAnswer followed_orbit(const System& system, const State& at_period_start, int period,
                              const SegmentOptions& options);

// The orbit near one on compliant stops with these states at the starts of its forcing periods.
FollowedAnswer followed_orbit(const System& system, const std::vector<State>& turns,
                              const SegmentOptions& options);

// The orbit from a state within a stuck phase, for a motion that is known to repeat after `period`
// forcing periods. Nothing is solved; its residual is the distance from repeating. Returns no orbit
// when the motion does not come back to that stuck phase.
FollowedAnswer orbit_through(const System& system, const MotionState<double>& at_section,
                             int period, const SegmentOptions& options);

// The orbit of a solution with these multipliers (at a release they are replaced by those of a
// section within the stuck phase before it); with `grazing`, a contact of zero duration counts as
// an impact at speed 0. Returns nullopt when there is no impact, when a rigid stop is stuck to and
// none is closed at the section, when the motion does not come back to the closed stops, or cannot
// be followed.
std::optional<Orbit> orbit_of(const System& system, const SegmentShooting& shooting,
                              const Vector& u, std::vector<Eigenvalue> multipliers,
                              const std::optional<GrazingContact>& grazing = {});

// The states at the starts of its forcing periods; requires an orbit on compliant stops.
std::vector<State> turns_of(const Orbit& orbit);

}  // namespace graze
