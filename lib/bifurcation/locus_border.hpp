// Where a locus of orbits that stick ends, by what happens at neighbours on it.
#pragma once

#include <optional>

#include "graze/bifurcation/orbit_locus.hpp"
#include "graze/orbit/itinerary.hpp"
#include "graze/system/scale.hpp"

namespace graze {

// How far apart, in units of the unknowns and ranges of the parameters, an orbit and what is none
// any more may be where a locus ends between them.
inline constexpr double kLocusBracket = 1e-7;

// Points of such a locus in each direction: beside a grazing steps may shrink with the speed of an
// impact, for ever.
inline constexpr int kMostLocusPoints = 1000;

// At GR where an impact outside the chatters is born or lost, or has all but lost its speed: the
// slope of the equations grows like its inverse, and the locus is followed no further. At CH where
// the stuck phases are others. Nothing where the locus goes on: two impacts at the head of a
// chatter may change places. `speed`: unit, m/s.
std::optional<OrbitLocusEnd> locus_end_between(const Itinerary& before, const Itinerary& now,
                                               double speed);

// Whether a point that no step led on from lies on a grazing: with an approach that touches, or
// such an impact.
bool grazes_at(const Passage& passage, const Itinerary& itinerary, const MotionScale& scale);

}  // namespace graze
