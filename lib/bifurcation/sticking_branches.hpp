// Branches of orbits that stick over a parameter of the scene.
//
// Continued are the equations of release_section.hpp. A branch consists of the orbits with the same
// stuck phases; how many impacts of a chatter are resolved before its tail is summed may change on
// the way and means nothing. It ends at CH, where one of its stuck phases shrinks to nothing (or
// one more begins): the chatter completes at the instant of the release, and beyond it the
// structure leaves before it has come to rest. Where its one stuck phase takes up the whole orbit
// instead it ends at LO: beyond, the structure is pressed on the stop for ever.
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

#include "graze/bifurcation/orbit_branch.hpp"
#include "graze/orbit/release_section.hpp"
#include "graze/system/system_family.hpp"

namespace graze {

// The equations of one release over the parameter. Remembers the system of the value asked for
// last, and what was followed last: one thread at a time.
class StickingEquations {
 public:
  // Refers to the family, which must outlive it. `reference`: see ReleaseSection.
  StickingEquations(const SystemFamily& family, const System& reference, const Release& release,
                    const StickingOptions& options)
      : StickingEquations(family, ReleaseSection(reference, release, options)) {}
  StickingEquations(const SystemFamily& family, ReleaseSection section);
  StickingEquations(const StickingEquations&) = delete;
  StickingEquations& operator=(const StickingEquations&) = delete;

  const ZeroProblem& problem() const { return problem_; }
  const ReleaseSection& section() const { return section_; }
  // The equations of the orbits of twice the period; they have the same unknowns.
  std::unique_ptr<StickingEquations> doubled() const {
    return std::make_unique<StickingEquations>(family_,
                                               section_.over(2 * section_.release().period));
  }
  // How far the motion is from coming back after half the period; empty where that is not whole.
  Vector halves_differ(const BranchPoint& solution) const;
  // Whether the branch passes an orbit of half the period between two neighbours.
  bool passes_half(const BranchPoint& a, const BranchPoint& b) const;
  // Null where the scene does not allow the value.
  const System* system_at(double value) const;
  // What becomes of the motion of a solution; nothing where it cannot be followed.
  std::optional<ReleaseReturn> follow(const BranchPoint& solution, bool minima = false) const;
  // What must stay positive for its events to stay what they are, with rates along its tangent;
  // `range`: of the parameter, as in the tangent.
  std::optional<std::vector<PassageMargin>> margins(const BranchPoint& solution,
                                                    double range) const;
  // Whether the impacts are part of the equations: not where all directions are held, N = m.
  bool see_impacts() const { return section_.size() > 1; }
  // The orbit of a solution that returns.
  std::optional<OrbitBranchPoint> judge(const BranchPoint& solution) const;

 private:
  const SystemFamily& family_;
  ReleaseSection section_;
  std::optional<ReleaseSection> half_;  // of half the period
  ZeroProblem problem_;
  mutable double cached_value_ = 0.0;
  mutable std::optional<System> cached_;
  // What was followed last.
  struct Followed {
    Vector u;
    double parameter = 0.0;
    bool minima = false;
    std::optional<ReleaseReturn> back;
  };
  mutable std::deque<Followed> followed_;
};

// An orbit beyond the CH or GR that ends a branch, or on the one that leaves it at a PD or BP.
struct StickingNeighbour {
  std::size_t special = 0;  // index of that among the branch's special points
  Orbit orbit;
  double value = 0.0;  // of the parameter
};

struct StickingTrace {
  std::optional<OrbitBranch> branch;
  std::vector<StickingNeighbour> neighbours;
  bool known = false;   // the orbit lies on a branch that was traced before
  std::string why_not;  // a sentence where there is neither
  bool cut_short = false;
  long long evaluations = 0, rejected = 0;
};

// All that have been traced so far.
class StickingBranches {
 public:
  // Refers to the family, which must outlive it. `range` says from where to where, how fast, and
  // when to stop; `switches`: whether neighbours at PD and BP are asked for.
  StickingBranches(const SystemFamily& family, ContinuationOptions range, bool switches)
      : family_(family), range_(std::move(range)), switches_(switches) {}

  // The branch through an orbit that sticks.
  StickingTrace trace(const Orbit& orbit, double value);

 private:
  struct Traced {
    std::unique_ptr<StickingEquations> equations;
    Branch branch;
  };
  bool knows(const std::vector<OrbitRelease>& releases, double value) const;

  const SystemFamily& family_;
  ContinuationOptions range_;
  bool switches_;
  std::deque<Traced> traced_;
};

}  // namespace graze
