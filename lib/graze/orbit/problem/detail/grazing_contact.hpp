// Where periodic motion touches a stop at zero speed, or comes near to that.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/segment_shooting.hpp"

namespace graze {

// An instant at which an orbit touches a stop at zero speed.
struct GrazingContact {
  int stop = 0;
  std::size_t turn = 0;  // segment from section to section
  double angle = 0.0;    // of the forcing, after its start, rad, up to the segment's end
  // m/s, at a compliant stop: a contact at that instant which begins no faster is the grazing
  // contact itself, slightly deep.
  double slowest = 0.0;
};

// Where the orbit of a solution, or of one near that, comes near to a grazing contact: its
// contacts, the slowest of its impacts outside chatters, and the smallest gap of each of its
// forcing periods, the nearest first; speeds v count as a depth, v^2/2 in units of the forced
// motion. Empty where there is none of these, or where the motion cannot be followed.
std::vector<GrazingContact> grazing_contacts_near(const System& system,
                                                  const SegmentShooting& shooting, const Vector& u);

// The motions of the segments that differ by one grazing contact: without the impact that it would
// be on a rigid stop, between the events before and after it. Returns nullopt when they cannot be
// followed.
std::optional<SegmentShooting> without_grazing(const System& system,
                                               const SegmentShooting& shooting, const Vector& u,
                                               const GrazingContact& grazing);

}  // namespace graze
