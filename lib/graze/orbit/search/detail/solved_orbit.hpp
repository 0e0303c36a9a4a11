// The orbit near a motion, solved for with its shortest period: by its impacts where these and the
// flights between them define the motion, else followed from section to section.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/settled.hpp"

namespace graze {

// The minimal orbit of a solution of the shooting equations, which a shorter orbit repeated several
// times solves too. Returns nullopt when the shorter pattern's own equations do not converge there.
std::optional<Orbit> minimal_orbit(const System& system, const ShootingProblem& problem,
                                   const ShootingSolution& solution);

// The orbit near impacts in this order; nullopt when Newton's method finds no solution, or as
// above.
std::optional<Orbit> orbit_near(const System& system, const ImpactPattern& pattern,
                                const std::vector<ImpactPoint>& points);

// The orbit that a repeating motion has settled on. Requires forcing.
FollowedAnswer orbit_near(const System& system, const SettledMotion& settled,
                          const SegmentOptions& options);

// The orbit of this system near an orbit of another, similar system, which must not stick.
std::optional<Orbit> orbit_near(const System& system, const Orbit& neighbour,
                                const SegmentOptions& options);

}  // namespace graze
