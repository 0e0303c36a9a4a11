#include "graze/orbit/problem/detail/release.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// A stuck phase that lasts less than this part of a forcing period has shrunk to nothing: 1e-10
// away from CH in the parameter it lasts (1e-10)^(3/5).
constexpr double kGone = 1e-6;

}  // namespace

std::optional<ReleaseReturn> return_of(const System& system, const SegmentShooting& shooting,
                                       const Vector& u, bool minima) {
  std::vector<TrajectorySegment> segments = shooting.follow(system, u, minima);
  if (segments.empty()) return {};
  const SegmentLayout& layout = shooting.layout();
  ReleaseReturn result;
  result.segment = std::move(segments.front());
  const Instant<double>& end = result.segment.end.instant;
  const std::vector<const SegmentSticking*> begun = sticking_begun(result.segment);
  result.itinerary = itinerary_of(result.segment, still_speed(system));
  result.shortest_sticking = std::numeric_limits<double>::infinity();
  // The time of the release satisfies the force equation to the accuracy of a solution.
  const double together = kShootingAccuracy * system.period();
  for (const SegmentSticking* sticking : begun) {
    result.sticking.push_back(sticking->stop);
    double duration = seconds_between(system, sticking->from, sticking->to);
    const bool at_end = sticking->to_end || seconds_between(system, sticking->to, end) <= together;
    if (sticking->stop == layout.released && at_end) result.returns = true;
    if (sticking->to_end)
      for (const SegmentSticking& rest : result.segment.sticking)
        if (rest.from_start && rest.stop == sticking->stop)
          duration += seconds_between(system, rest.from, rest.to);
    result.shortest_sticking = std::min(result.shortest_sticking, duration);
  }
  for (const int i : layout.closed)
    if (i != layout.released &&
        result.segment.end.contacts[static_cast<std::size_t>(i)] != Contact::kClosed)
      result.returns = false;
  return result;
}

bool has_shrunk(const ReleaseReturn& back, double period) {
  return back.shortest_sticking <= kGone * period;
}

}  // namespace graze
