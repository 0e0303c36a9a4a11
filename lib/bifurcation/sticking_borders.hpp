// Where a branch of orbits that stick ends between two solutions of its equations, at its borders:
// at CH, where its stuck phases change, at LO, where one of them has grown to all of the period, or
// at GR, where an impact outside the chatters is born or lost.
//
// A step of the trace may pass either without noticing. Both show in what happens along the
// solutions on its two sides: the stuck phases, and the impacts outside the chatters
// (`ReleaseReturn::itinerary`). The border is bisected to the last digits of arclength
// (sticking_approach.hpp), and what lies there says what it is (sticking_completion.hpp,
// sticking_grazing.hpp). Nothing has to: where two impacts of nearly equal speed change places at
// the head of a chatter, the itinerary changes and the motion does not.
//
// Between two solutions with the same events there may be others all the same (hidden_events.hpp).
#pragma once

#include <functional>
#include <vector>

#include "graze/bifurcation/hidden_events.hpp"
#include "graze/bifurcation/passage_equations.hpp"
#include "graze/bifurcation/sticking_approach.hpp"
#include "graze/bifurcation/sticking_tip.hpp"
#include "graze/continuation/corrector.hpp"

namespace graze {

class StickingBorders {
 public:
  // Refers to both, which must outlive it.
  StickingBorders(const PassageEquations& equations, const ContinuationOptions& options);
  StickingBorders(const StickingBorders&) = delete;
  StickingBorders& operator=(const StickingBorders&) = delete;

  // Whether the branch ends between neighbours a and b.
  bool passes(const BranchPoint& a, const BranchPoint& b);
  // What ends the branch between a, an orbit, and its neighbour b; "not converged" where that
  // cannot be told.
  StickingTip between(const BranchPoint& a, const BranchPoint& b);
  // What ends it at the last of these points, where it was followed no further.
  StickingTip at_last(const std::vector<BranchPoint>& reached);
  // The grazings between orbits a and b that equations which do not see impacts (N = m) pass.
  std::vector<StickingTip> passed(const BranchPoint& a, const BranchPoint& b);

 private:
  void walk(const BranchPoint& a, const BranchPoint& b, bool impacts,
            const std::function<bool(const StickingTip&)>& is_enough);
  StickingTip grazing(const StickingApproach& there, const ReleaseReturn& here);

  const PassageEquations& equations_;
  const ContinuationOptions& options_;
  Corrector corrector_;
  HiddenEvents hidden_;
};

}  // namespace graze
