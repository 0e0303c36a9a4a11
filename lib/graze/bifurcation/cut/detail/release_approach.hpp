// The approach from an orbit that sticks towards a solution with other events, as far as the events
// stay the same: the boundary between the two is bisected to the last digits of arclength.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "graze/bifurcation/problem/detail/segment_equations.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

struct ReleaseApproach {
  // The solutions on this side, the orbit it started from first; never empty.
  std::vector<SolutionPoint> reached;
  ReleaseReturn last;  // of the last of these solutions
  // The return of the nearest solution beyond, if its motion could be followed.
  std::optional<ReleaseReturn> beyond;
  SolutionPoint at_beyond;
  // Orbits beyond, with the stops that they stick to; those nearest to the boundary last.
  std::vector<std::pair<SolutionPoint, std::vector<int>>> others;
  bool settled = false;  // bisected to the last digits
};

// Approaches from `a`, whose events are those of `at_a`, towards `b`; `impacts`: see
// has_same_events().
ReleaseApproach approach_boundary(const SegmentEquations& equations, Corrector& corrector,
                                  const StopSignal& stop, const SolutionPoint& a,
                                  const SolutionPoint& b, const ReleaseReturn& at_a, bool impacts);

}  // namespace graze
