// Starts of a search for orbits on compliant stops, as states at the start of a forcing period:
// from
//
//   closed form   the (p, 1) orbits of rigid stops in their place, with the restitution that a
//                 contact of the same effective mass at the same speed has;
//   random        rough guesses at impacts (rough_guess.hpp), followed through their contacts.
//
// Also starts of a search for orbits that stick, from an impact that is followed by no flight.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {

// Follows the motion from just before an impact on this stop to the end of the forcing period.
// Returns nullopt when it cannot be followed so far.
std::optional<State> period_end_after(const System& system, const ImpactPoint& impact, int stop,
                                      const SegmentOptions& segment);

std::vector<State> closed_form_contacts(const System& system, int period,
                                        const SegmentOptions& segment);

// At most `count` starts on this stop; `speed`, m/s, of the forced motion.
std::vector<State> rough_contacts(const System& system, int stop, int period, int count,
                                  double speed, std::uint64_t seed, const SegmentOptions& segment);

}  // namespace graze
