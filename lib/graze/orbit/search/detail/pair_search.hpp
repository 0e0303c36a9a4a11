// The orbits of two impacts on pairs of stops, from the closed form (two_impacts.hpp): each of its
// zeros is refined and judged, on several cores.
#pragma once

#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/orbit/closed_form/detail/two_impacts.hpp"
#include "graze/orbit/search/detail/phase_judge.hpp"

namespace graze {

struct PairSolutions {
  int tried = 0;                         // zeros of the closed form
  int converged = 0;                     // that are solutions
  int refused = 0;                       // solutions certainly not admissible, unless these are
                                         // wanted
  std::vector<PhaseSolution> solutions;  // the others, by pair
};

// Solves each pair of stops to which the closed form applies. `length`, m, and `speed`, m/s: of the
// forced motion. When it was asked to stop, the solutions found so far.
PairSolutions solve_pairs(const TwoImpacts& form, const PeriodicResponse& response,
                          const PhaseJudge& judge, const std::vector<std::vector<int>>& pairs,
                          const MotionScale& scale, int threads, const StopSignal& stop);

}  // namespace graze
