// The motion of an orbit that sticks, from the release at which it is continued
// (segment_shooting.hpp).
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/itinerary.hpp"
#include "graze/orbit/problem/detail/segment_shooting.hpp"

namespace graze {

// The motion from a release.
struct ReleaseReturn {
  TrajectorySegment segment;
  // The stops that were closed by a chatter (or an impact with r = 0), in time order.
  std::vector<int> sticking;
  bool returns = false;  // to the same stops, released at the section
  // The shortest of these stuck phases, s; infinite where there is none.
  double shortest_sticking = 0.0;
  // Its events change where an impact is born or lost, but also where two impacts at the head of a
  // chatter come to be equally fast.
  Itinerary itinerary{};
};

// Requires a layout with one section, at a release. Returns nullopt when the motion cannot be
// followed. `minima`: as in SegmentOptions.
std::optional<ReleaseReturn> return_of(const System& system, const SegmentShooting& shooting,
                                       const Vector& u, bool minima = false);

// Whether a stuck phase of the motion has shrunk to nothing. `period` of the forcing, s.
bool has_shrunk(const ReleaseReturn& back, double period);

}  // namespace graze
