// What happens in a segment besides its chatters: how many impacts of a chatter are resolved before
// its tail is summed means nothing.
#pragma once

#include <vector>

#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {

struct Itinerary {
  // The stops of impacts that are not of a chatter, and -1 - stop for a stuck phase that begins.
  std::vector<int> events;
  // The slowest impact that is not of a chatter, a run of ever slower impacts on a stop that leads
  // to a stuck phase on it, m/s; infinite where there is none.
  double slowest = 0.0;
  int slowest_stop = -1;  // that it is with
  Instant<double> slowest_at{};
};

// The stuck phases that begin within the segment, in time order.
std::vector<const SegmentSticking*> sticking_begun(const TrajectorySegment& segment);

// `still`, m/s: impacts no faster are rounding; see still_speed().
Itinerary itinerary_of(const TrajectorySegment& segment, double still);

// What must stay positive for the itinerary to stay what it is, and its rate along a direction: the
// speed of an impact, or the gap at an interior approach that is not between two impacts of one
// chatter.
struct SegmentMargin {
  bool is_speed = false;
  std::size_t place = 0;  // how many impacts of the itinerary come before it
  int stop = 0;
  double after = 0.0;              // of an approach: s since the event before it
  double value = 0.0, rate = 0.0;  // m/s or m, and along the direction
};

// In time order, of a segment that was followed along a direction.
std::vector<SegmentMargin> margins_of(const TrajectorySegment& segment, double still);

}  // namespace graze
