#include "graze/bifurcation/problem/special_orbit.hpp"

#include "graze/orbit/problem/detail/followed_orbit.hpp"

namespace graze {

bool SpecialOrbit::sticks() const {
  return followed && !closed_stops(followed->states.front()).empty();
}

FollowedAnswer orbit_again(const System& system, const SpecialOrbit& special,
                           SegmentOptions segment) {
  const SpecialOrbit::Followed& at = *special.followed;
  segment.closure_speed = at.closure_speed;
  if (special.sticks()) return orbit_through(system, at.states.front(), at.period, segment);
  Orbit orbit;
  orbit.period = at.period;
  orbit.section = OrbitSection{{}, at.states, at.closure_speed};
  return {orbit, ""};
}

}  // namespace graze
