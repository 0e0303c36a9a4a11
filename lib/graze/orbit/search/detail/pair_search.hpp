// The orbits of two impacts on pairs of stops, from the closed form (two_impacts.hpp): every zero
// of it refined and judged, on several cores.
#pragma once

#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/orbit/closed_form/detail/two_impacts.hpp"
#include "graze/orbit/search/detail/phase_judge.hpp"

namespace graze {

struct PairSolutions {
  int tried = 0;                         // zeros of the closed form
  int converged = 0;                     // that are solutions
  int refused = 0;                       // of these: surely no orbits, where such are not wanted
  std::vector<PhaseSolution> solutions;  // the others, by pair
};

// On each pair of stops, on which the closed form holds. `length`, m, and `speed`, m/s: of the
// forced motion. After a stop what was found so far.
PairSolutions solve_pairs(const TwoImpacts& form, const PeriodicResponse& response,
                          const PhaseJudge& judge, const std::vector<std::vector<int>>& pairs,
                          const MotionScale& scale, int threads, const StopSignal& stop);

}  // namespace graze
