// The boundaries between neighbours on a traced branch of orbits, and beyond its last point, at
// which its solutions stop being orbits of the same kind. How a boundary is detected and located
// depends on the motion between the nodes (flight_boundaries.hpp, contact_boundaries.hpp,
// release_boundaries.hpp).
#pragma once

#include <optional>
#include <vector>

#include "graze/bifurcation/problem/orbit_branch.hpp"

namespace graze {

// A point or special point on a branch.
struct BranchPlace {
  OrbitBranchPoint at;
  std::optional<SpecialPoint> special{};
  bool listed = true;  // is an orbit, or is wanted all the same
  // For a branch that ends here.
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  bool begins = false;  // a part of other orbits begins here
  // Orbits that the special point leads to, or starts for these.
  std::vector<OrbitBranchPoint> others{};
};

// A solution and its classification.
struct JudgedPoint {
  const SolutionPoint& point;
  const BranchPlace& place;
};

// How a branch ends beyond the last of its orbits.
struct BranchTip {
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  std::optional<BranchPlace> place{};  // in place of the trace's last point
};

// May cache its last results: for one thread at a time.
class BranchBoundaries {
 public:
  virtual ~BranchBoundaries() = default;

  // Whether a solution is to be listed: it is an orbit, or virtual solutions are wanted.
  virtual bool lists(const SolutionPoint& solution) const = 0;
  // Whether the branch is to be traced on beyond `here`, and whether a step is short enough to show
  // what happens within it.
  virtual bool goes_on(const SolutionPoint& previous, const SolutionPoint& here) = 0;
  virtual bool resolves(const SolutionPoint& /*from*/, const SolutionPoint& /*to*/) { return true; }

  // Whether two neighbours lie on two sides of a corner, across which a branch goes on with an
  // unrelated tangent.
  virtual bool lie_across(const SolutionPoint& /*a*/, const SolutionPoint& /*b*/) const {
    return false;
  }

  // Adds the places strictly between two neighbours, in order.
  virtual void pass(const JudgedPoint& a, const JudgedPoint& b,
                    std::vector<BranchPlace>& places) = 0;
  // Where the trace was halted or no step succeeded: cuts it off at the boundary there. Returns
  // nullopt when the trace's own end is right.
  virtual std::optional<BranchTip> close(Branch& /*trace*/, std::size_t /*side*/) { return {}; }
  // The orbit at a grazing, as one of those on its other side.
  virtual std::optional<Orbit> across(const SpecialPoint& /*special*/) const { return {}; }
};

}  // namespace graze
