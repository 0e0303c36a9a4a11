// Where periodic motion touches a stop at no speed, or comes near to that.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/segment_shooting.hpp"

namespace graze {

// An instant at which an orbit touches a stop at no speed.
struct GrazingContact {
  int stop = 0;
  std::size_t turn = 0;  // segment from section to section
  double angle = 0.0;    // of the forcing, after its start, rad, up to the segment's end
  // m/s, of a compliant stop: a contact at that instant which begins no faster is the grazing
  // contact itself, met a little deep.
  double slowest = 0.0;
};

// Where the orbit of a solution, or of one near that, comes near to a grazing contact: its
// contacts, the slowest of its impacts outside chatters, and the least gap of each of its turns,
// the nearest first, told by v^2/2 as the depth in units of the forced motion. Empty where there is
// none of these, or where the motion cannot be followed.
std::vector<GrazingContact> grazing_contacts_near(const System& system,
                                                  const SegmentShooting& shooting, const Vector& u);

// The motions of those segments that have one grazing contact more or less besides: without the
// impact that it would be on a rigid stop, between the events before and after it. Nothing where
// they cannot be followed.
std::optional<SegmentShooting> without_grazing(const System& system,
                                               const SegmentShooting& shooting, const Vector& u,
                                               const GrazingContact& grazing);

}  // namespace graze
