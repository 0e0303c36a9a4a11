// Boundaries of orbits that stick, continued from a release. A branch consists of the orbits with
// the same stuck phases; the number of impacts of a chatter that are resolved before its tail is
// summed may change along it. It ends at CH, where its stuck phases change, at LO, where one of
// them has grown to the whole period, or at GR, where an impact outside the chatters is born or
// lost.
//
// A step of the trace may pass either without noticing. Both show in the events of the solutions on
// its two sides: the stuck phases, and the impacts outside the chatters
// (`ReleaseReturn::itinerary`). The boundary is bisected to the last digits of arclength
// (release_approach.hpp), and classified there (release_completion.hpp, release_grazing.hpp). It
// may be none of these: where two impacts of nearly equal speed exchange places at the head of a
// chatter, the itinerary changes and the motion does not.
//
// Two solutions with the same events may have others between them (hidden_events.hpp).
#pragma once

#include <functional>
#include <vector>

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/cut/detail/hidden_events.hpp"
#include "graze/bifurcation/cut/detail/release_approach.hpp"
#include "graze/bifurcation/cut/detail/release_tip.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

class ReleaseBoundaries : public BranchBoundaries {
 public:
  // Refers to both, which must outlive it. `switches`: whether orbits beyond a boundary are wanted.
  ReleaseBoundaries(const SegmentEquations& equations, const ContinuationOptions& options,
                    bool switches = false);

  bool lists(const SolutionPoint& solution) const override {
    return equations_.judge(solution).has_value();
  }
  bool goes_on(const SolutionPoint& previous, const SolutionPoint& here) override;
  // Adds grazings where the equations do not contain impacts (N = m) and pass them.
  void pass(const JudgedPoint& a, const JudgedPoint& b, std::vector<BranchPlace>& places) override;
  std::optional<BranchTip> close(Branch& trace, std::size_t side) override;

 private:
  // The end of the branch between a, an orbit, and its neighbour b; "not converged" when it cannot
  // be classified.
  ReleaseTip between(const SolutionPoint& a, const SolutionPoint& b);
  // The end at the last of these points, where the trace stopped.
  ReleaseTip at_last(const SolutionPoint& at);
  // The special point of an end; nullopt when it has none.
  std::optional<BranchPlace> place_of(const ReleaseTip& tip) const;
  void end_at(const SolutionPoint& boundary, Branch& trace, std::size_t side);
  void walk(const SolutionPoint& a, const SolutionPoint& b, bool impacts,
            const std::function<bool(const ReleaseTip&)>& is_enough);
  ReleaseTip grazing(const ReleaseApproach& there, const ReleaseReturn& here);

  const SegmentEquations& equations_;
  const ContinuationOptions& options_;
  bool switches_;
  Corrector corrector_;
  HiddenEvents hidden_;
};

}  // namespace graze
