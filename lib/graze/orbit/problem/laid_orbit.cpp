#include "graze/orbit/problem/detail/laid_orbit.hpp"

#include <algorithm>
#include <utility>

#include "graze/base/angle.hpp"

namespace graze {

std::vector<LaidOrbit> layouts_of(const System& system, const Orbit& orbit,
                                  const SegmentOptions& options) {
  if (!orbit.sticks()) return {{SegmentLayout::fixed_phase(orbit.period), 0.0, turns_of(orbit)}};
  std::vector<LaidOrbit> found;
  const MotionState<double>& start = orbit.section->states.front();
  const TrajectorySegment round =
      pass(system, start, {start.instant.period + orbit.period, start.instant.local}, options);
  for (const SegmentSticking& sticking : round.sticking) {
    if (sticking.to_end) continue;
    const TrajectorySegment there = pass(system, start, sticking.to, options);
    if (!there.failure.empty()) continue;
    LaidOrbit one;
    SegmentLayout& layout = one.layout;
    layout.period = orbit.period;
    layout.released = sticking.stop;
    for (std::size_t i = 0; i < system.stops.size(); ++i)
      if (static_cast<int>(i) == sticking.stop || there.end.contacts[i] == Contact::kClosed)
        layout.closed.push_back(static_cast<int>(i));
    one.theta = wrapped(system.forcing()->frequency * sticking.to.local + system.forcing()->phase);
    one.states = {{there.end.q, there.end.qdot}};
    one.held = seconds_between(system, sticking.from, sticking.to);
    for (const SegmentSticking& before : round.sticking)
      if (sticking.from_start && before.to_end && before.stop == sticking.stop)
        one.held += seconds_between(system, before.from, before.to);
    found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), [](const LaidOrbit& a, const LaidOrbit& b) {
    const std::size_t at_a = a.layout.closed.size(), at_b = b.layout.closed.size();
    return at_a != at_b ? at_a > at_b : a.held > b.held;
  });
  return found;
}

}  // namespace graze
