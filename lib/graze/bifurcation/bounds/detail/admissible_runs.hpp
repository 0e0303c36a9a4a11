// The runs of orbits among the (p, 1) solutions of a stop: along each of the two families over
// every interval with solutions (solution_ranges.hpp), every part on which the solution is an
// orbit.
//
// The part not yet covered by a traced branch is halved until over each cell one instant is beyond
// a stop, or the impact speed is negative, all over the cell, by the bounds of
// solution_family_form.hpp; or until the solution in the middle of a cell is an orbit, whose branch
// is traced at once and covers its values. So a run can only be missed in cells narrower than
// kResolution (next to the ends of runs and folds, which no cell can exclude), or in those that the
// budget leaves; the widest of these is reported.
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
  double resolution = 0;  // width of cells that were not searched, in units of the parameter
  int lost = 0;           // orbits that were seen and could not be traced
};

// What the search needs from the tracer of branches.
struct RunTracer {
  // Traces the branch through a solution.
  std::function<void(const ImpactPoint& point, double value)> trace;
  // Passes the listed branches of the stop's (p, 1) orbits since the last call.
  std::function<void(const std::function<void(const OrbitBranch&)>&)> new_branches;
  std::function<bool()> stopped;
};

// Requires a stop whose restitution is constant and not zero (else sticking, and not penetration,
// may make a solution virtual), and free motion between impacts that does not repeat by itself: see
// bounded_runs.
RunSearch search_runs(const SystemFamily& family, const SolutionRanges& ranges,
                      const RunTracer& tracer);

// Whether runs can be searched for by bounds.
bool bounded_runs(const System& system, int stop);

}  // namespace graze
