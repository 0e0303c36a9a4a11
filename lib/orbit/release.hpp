// What becomes of the motion of an orbit that sticks from the release at which it is continued
// (passage_shooting.hpp).
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/passage_shooting.hpp"

namespace graze {

// What became of the motion from a release.
struct ReleaseReturn {
  Passage passage;
  // The stops that were closed by a chatter (or an impact with r = 0), in time order.
  std::vector<int> holds;
  bool returns = false;  // to the same stops, released at the section
  // The shortest of these stuck phases, s; infinite where there is none.
  double shortest_hold = 0.0;
  // What happens in time order: the stops of impacts that are not of a chatter, and -1 - stop for a
  // stuck phase that begins. Changes where such an impact is born or lost, but also where two
  // impacts at the head of a chatter come to be equally fast.
  std::vector<int> itinerary;
  // The slowest impact that is not of a chatter, a run of ever slower impacts on a stop that leads
  // to a stuck phase on it, m/s; infinite where there is none.
  double slowest = 0.0;
};

// Requires a layout with one section, at a release. Nothing where the motion cannot be followed.
// `minima`: as in PassageOptions.
std::optional<ReleaseReturn> return_of(const System& system, const PassageShooting& shooting,
                                       const Vector& u, bool minima = false);

}  // namespace graze
