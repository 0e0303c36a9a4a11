// The sequence of events of a segment without the impacts of its chatters, whose number depends on
// where the tail is summed.
#pragma once

#include <vector>

#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {

struct Itinerary {
  // The stops of impacts that belong to no chatter, and -1 - stop for a stuck phase that begins.
  std::vector<int> events;
  // The slowest impact that belongs to no chatter (a run of ever slower impacts on a stop that
  // leads to a stuck phase on it), m/s; infinite where there is none.
  double slowest = 0.0;
  int slowest_stop = -1;  // the stop of that impact
  Instant<double> slowest_at{};
};

// The stuck phases that begin within the segment, in time order.
std::vector<const SegmentSticking*> sticking_begun(const TrajectorySegment& segment);

// `still`, m/s: impacts no faster are rounding; see still_speed().
Itinerary itinerary_of(const TrajectorySegment& segment, double still);

// A quantity that must stay positive for the itinerary to stay the same, and its rate along a
// direction: the speed of an impact, or the gap at an interior approach that is not between two
// impacts of one chatter.
struct SegmentMargin {
  bool is_speed = false;
  std::size_t place = 0;  // how many impacts of the itinerary come before it
  int stop = 0;
  double after = 0.0;              // for an approach: s since the event before it
  double value = 0.0, rate = 0.0;  // m/s or m, and along the direction
};

// In time order, for a segment that was followed along a direction.
std::vector<SegmentMargin> margins_of(const TrajectorySegment& segment, double still);

}  // namespace graze
