// The orbits of two impacts on pairs of stops, from the closed form (two_impacts.hpp): each of its
// zeros is refined and judged, on several cores.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/orbit/closed_form/detail/two_impacts.hpp"
#include "graze/orbit/search/detail/phase_search.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Decides which solutions of the phase problem are orbits.
class PhaseJudge {
 public:
  // Refers to the system and its response, which must outlive it. `keep_virtual`: virtual solutions
  // are wanted too.
  PhaseJudge(const System& system, const PeriodicResponse& response, const MotionScale& scale,
             bool keep_virtual)
      : system_(system), response_(response), scale_(scale), keep_virtual_(keep_virtual) {}

  // The orbit of a solution; only its outline when it is certainly virtual and that is not wanted.
  // Returns nullopt when Newton's method loses it or it repeats a shorter one.
  std::optional<Orbit> orbit_of(const PhaseSolution& solution) const;

  // Whether the motion at some instants shows that the solution is virtual, where that is not
  // wanted: cheap compared with a search for the minima of its gaps.
  bool is_refused(const PhaseSolution& solution) const;

 private:
  bool surely_virtual(const PhaseSolution& solution, const std::vector<ImpactPoint>& points) const;

  const System& system_;
  const PeriodicResponse& response_;
  MotionScale scale_;
  bool keep_virtual_;
};

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
