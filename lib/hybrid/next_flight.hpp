// What all who follow a motion share (a run, a passage, the search for what a motion settles on):
// how far it may fly next, the tail of a chatter that was summed, and why it cannot go on.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "graze/hybrid/motion.hpp"

namespace graze {

// The tail of a chatter, summed: the motion is at rest on its stops from the instant at which that
// was done, but whoever reads events hears of it when the tail is over.
struct ChatterTail {
  std::vector<int> stops;  // ascending
  Instant<double> over;
  bool holds(int stop) const { return std::binary_search(stops.begin(), stops.end(), stop); }
};

// Right after the motion has closed it.
ChatterTail tail_of(const Motion<double>& motion, const ClosedChatter<double>& closed);

// Seconds on the local clock, as Motion::fly takes them.
struct NextFlight {
  double until = 0.0;
  double horizon = 0.0;
  bool cut = false;  // by the end: the flight goes on beyond it
};

// From the present instant to the end of the forcing period, of the tail or of `longest` seconds
// (longest_flight of scale.hpp), whichever is first. Where `end` comes before that the flight is
// cut there, but its event is searched as if it went on: a motion that goes on from the cut finds
// the same to the last bit.
NextFlight next_flight(const Motion<double>& motion, const Instant<double>& end,
                       const std::optional<ChatterTail>& tail = {},
                       double longest = std::numeric_limits<double>::infinity());

// Why the motion does not go on after this arrival: a main clause; empty where it does.
std::string failure_of(const Motion<double>& motion, const Arrival<double>& arrival);

}  // namespace graze
