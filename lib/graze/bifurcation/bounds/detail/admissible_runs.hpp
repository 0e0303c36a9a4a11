// The runs of orbits among the (p, 1) solutions of a stop: along each of the two families over
// every interval with solutions (solution_ranges.hpp), every part that is an orbit of the system.
//
// What is not yet covered by a traced branch is halved until over each cell one instant is beyond a
// stop all over it, or the impact speed is negative, as solution_family_form.hpp bounds them; or
// until the solution in the middle of a cell is an orbit, which is traced at once and covers what
// it covers. So no run is passed over but in cells narrower than kResolution (next to the ends of
// runs and folds, which no cell can hold), or in those that the budget leaves over; the widest of
// these are told.
#pragma once

#include <functional>

#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/bounds/detail/solution_ranges.hpp"
#include "graze/bifurcation/problem/orbit_branch.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

struct RunSearch {
  long long cells = 0;    // that were looked at
  int undecided = 0;      // left over by the budget
  double widest = 0.0;    // of them
  double resolution = 0;  // width of cells that were not looked into, in units of the parameter
  int lost = 0;           // orbits that were seen and could not be traced
};

// What the search asks of those who trace.
struct RunTracer {
  // Traces the branch through a solution.
  std::function<void(const ImpactPoint& point, double value)> trace;
  // Hands over the listed branches of the stop's (p, 1) orbits, those since the last call only.
  std::function<void(const std::function<void(const OrbitBranch&)>&)> new_branches;
  std::function<bool()> stopped;
};

// Requires a stop whose restitution is constant and not zero (where an impact leaves the structure
// at rest, sticking and no penetration may be what makes it no orbit), and that the motion between
// impacts does not repeat by itself: see bounded_runs.
RunSearch search_runs(const SystemFamily& family, const SolutionRanges& ranges,
                      const RunTracer& tracer);

// Whether runs can be sought by bounds.
bool bounded_runs(const System& system, int stop);

}  // namespace graze
