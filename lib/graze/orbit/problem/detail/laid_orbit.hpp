// The layouts by which an orbit that is followed can be continued (segment_shooting.hpp).
#pragma once

#include <vector>

#include "graze/orbit/problem/detail/followed_orbit.hpp"

namespace graze {

// An orbit on the sections of a layout.
struct LaidOrbit {
  SegmentLayout layout;
  double theta = 0.0;  // of its sections, rad
  std::vector<State> states;
  double held = 0.0;  // how long the stop that is released there was closed, s
};

// The layouts by which an orbit that is followed can be continued, the preferred one first. Where
// it sticks they are at its releases, that of the most closed stops first, and among these the one
// after the longest stuck phase; none where its stops are never released. Else its fixed phase.
std::vector<LaidOrbit> layouts_of(const System& system, const Orbit& orbit,
                                  const SegmentOptions& options);

}  // namespace graze
