// The orbit near a motion, solved for and under its shortest period: by its impacts where these and
// the arcs between them tell the motion, else followed from section to section.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/settled.hpp"

namespace graze {

// Of a solution of the shooting equations: several rounds of a shorter orbit solve those of the
// longer pattern too. Nothing where the shorter pattern's own equations do not converge there.
std::optional<Orbit> minimal_orbit(const System& system, const ShootingProblem& problem,
                                   const ShootingSolution& solution);

// Near impacts in this order; nothing where Newton's method leads to no solution, or as above.
std::optional<Orbit> orbit_near(const System& system, const ImpactPattern& pattern,
                                const std::vector<ImpactPoint>& points);

// That a motion which repeats has settled on. Requires forcing.
FollowedAnswer orbit_near(const System& system, const SettledMotion& settled,
                          const SegmentOptions& options);

// What an orbit of another system nearby has become; requires one that does not stick.
std::optional<Orbit> orbit_near(const System& system, const Orbit& neighbour,
                                const SegmentOptions& options);

}  // namespace graze
