// Releases of orbits that stick, at which their branches are continued (passage_shooting.hpp), and
// what becomes of the motion from one.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/followed_orbit.hpp"

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

// The orbit of such a solution; nothing where the motion does not return.
std::optional<Orbit> orbit_at_release(const System& system, const PassageShooting& shooting,
                                      const Vector& u);

// The releases of an orbit that sticks, that of the most closed stops first, and of these the one
// after the longest stuck phase. Empty where its stops are never let go.
struct OrbitRelease {
  PassageLayout layout;
  double theta = 0.0;  // rad
  State state;
};
std::vector<OrbitRelease> releases_of(const System& system, const Orbit& orbit,
                                      const PassageOptions& options);

}  // namespace graze
