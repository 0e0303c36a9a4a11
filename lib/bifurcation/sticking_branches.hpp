// Branches of orbits that stick over a parameter of the scene.
//
// Continued are the equations of one release (passage_equations.hpp). A branch consists of the
// orbits with the same stuck phases; how many impacts of a chatter are resolved before its tail is
// summed may change on the way and means nothing. It ends at CH, where one of its stuck phases
// shrinks to nothing (or one more begins): the chatter completes at the instant of the release, and
// beyond it the structure leaves before it has come to rest. Where its one stuck phase takes up the
// whole orbit instead it ends at LO: beyond, the structure is pressed on the stop for ever.
//
// Where an impact outside the chatters loses its speed, or an interior approach touches a stop, the
// map has a corner and no derivative on one side: a branch of several modes ends there with GR,
// also where a step would lead on beyond it, or beyond two of them. With N = m held directions the
// equations do not see it: the grazing is a special point and the branch goes on.
//
// CH is where the motion stops coming to rest, and it is located as that: between an orbit
// that sticks and a solution that does not, to the last digits of arclength. A chatter is summed
// only where the push outlives it with room to spare, whatever the closure speed; nearer to CH than
// that it is followed impact by impact. So CH does not depend on how chatters are closed. The
// duration L of the stuck phase goes as the distance to CH to the power 3/5, nearly: where the push
// falls to zero linearly at the release, a chatter that just completes shrinks by about r^(3/5) in
// time from impact to impact, and what parts it from one that does not grows by about 1/r.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/bifurcation/passage_equations.hpp"
#include "graze/bifurcation/sticking_verdict.hpp"
#include "graze/orbit/laid_orbit.hpp"

namespace graze {

// What came of an orbit as a start.
struct StickingTrace {
  std::optional<OrbitBranch> branch;  // the one through it, where it was traced
  std::vector<StickingNeighbour> neighbours;
  bool known = false;      // the orbit lies on a branch that was traced before
  std::string why_not;     // a sentence where there is neither
  bool cut_short = false;  // the branch could not be followed to an end
  long long evaluations = 0, rejected = 0;
};

// All that have been traced so far.
class StickingBranches {
 public:
  // Refers to the family, which must outlive it. `range` says from where to where, how fast, and
  // when to stop; `switches`: whether neighbours at PD and BP are asked for;
  // `max_impacts`: of one motion.
  StickingBranches(const SystemFamily& family, ContinuationOptions range, bool switches,
                   long long max_impacts)
      : family_(family), range_(std::move(range)), switches_(switches), max_impacts_(max_impacts) {}

  // The branch through an orbit that sticks.
  StickingTrace trace(const Orbit& orbit, double value);

 private:
  struct Traced {
    std::unique_ptr<PassageEquations> equations;
    Branch branch;
  };
  bool knows(const std::vector<LaidOrbit>& releases, double value) const;
  StickingTrace trace_through(const BranchPoint& start, Traced traced);

  const SystemFamily& family_;
  ContinuationOptions range_;
  bool switches_;
  long long max_impacts_;
  std::deque<Traced> traced_;
};

}  // namespace graze
