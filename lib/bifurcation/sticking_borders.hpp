// Where a branch of orbits that stick ends between two solutions of its equations: at CH, where its
// stuck phases change, at LO, where one of them has grown to all of the period, or at GR, where an
// impact outside the chatters is born or lost.
//
// A step of the trace may pass either without noticing. Both show in what happens along the
// solutions on its two sides: the stuck phases, and the impacts outside the chatters
// (`ReleaseReturn::itinerary`). The border is bisected to the last digits of arclength, and what
// lies there says what it is. Nothing has to: where two impacts of nearly equal speed change places
// at the head of a chatter, the itinerary changes and the motion does not.
//
// Between two solutions with the same events there may be others all the same: an approach touches
// and is clear again. Speeds and gaps with their rates at both tell where to look
// (margin_course.hpp).
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "graze/bifurcation/sticking_branches.hpp"
#include "graze/continuation/corrector.hpp"
#include "graze/continuation/margin_course.hpp"

namespace graze {

// One end of a traced branch.
struct StickingTip {
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  std::optional<BranchPoint> border;  // the special point that ends it
  bool by_speed = false;              // of a grazing
  bool interrupted = false;           // of CH and LO
  double value = 0.0;                 // of the parameter there
  std::optional<BranchPoint> beyond;  // an orbit on the other side
};

class StickingBorders {
 public:
  // Refers to both, which must outlive it.
  StickingBorders(const StickingEquations& equations, const ContinuationOptions& options);

  // What ends the branch between a, an orbit, and its neighbour b; "not converged" where that
  // cannot be told.
  StickingTip between(const BranchPoint& a, const BranchPoint& b);
  // What ends it at the last of these points, where it was followed no further.
  StickingTip at_last(const std::vector<BranchPoint>& reached);
  // Whether the branch ends between neighbours a and b.
  bool passes(const BranchPoint& a, const BranchPoint& b);
  // The grazings between orbits a and b that equations which do not see impacts (N = m) pass.
  std::vector<StickingTip> passed(const BranchPoint& a, const BranchPoint& b);
  // Whether a stuck phase has shrunk to nothing.
  bool has_shrunk(const ReleaseReturn& back, const BranchPoint& at) const;

 private:
  struct Approach;
  double shortest_opening(const ReleaseReturn& back, const BranchPoint& at) const;
  bool is_interrupted(const ReleaseReturn& back, const BranchPoint& at) const;
  double last_opening(const std::vector<BranchPoint>& reached) const;
  bool is_at_rest(const ReleaseReturn& back, const BranchPoint& at) const;
  Approach approach(const BranchPoint& a, const BranchPoint& b, const ReleaseReturn& at_a,
                    bool see_impacts);
  void walk(const BranchPoint& a, const BranchPoint& b, bool see_impacts,
            const std::function<bool(const StickingTip&)>& is_enough);
  std::optional<std::vector<PassageMargin>> margins(const BranchPoint& solution);
  std::vector<MarginCourse> courses(const BranchPoint& a, const BranchPoint& b);
  std::optional<BranchPoint> unlike_between(const BranchPoint& a, const BranchPoint& b,
                                            const ReleaseReturn& at_a, int& looks);
  StickingTip completion(Approach& approach, const ReleaseReturn& at_a) const;

  const StickingEquations& equations_;
  const ContinuationOptions& options_;
  Corrector corrector_;
  // Margins of the solutions asked for last.
  struct Known {
    BranchPoint solution;
    std::optional<std::vector<PassageMargin>> margins;
  };
  std::deque<Known> known_;
};

}  // namespace graze
