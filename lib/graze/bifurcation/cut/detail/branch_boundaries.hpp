// What lies between neighbours on a traced branch of orbits, and beyond its last: the boundaries
// where its solutions stop being orbits of the same kind. How one shows and is located is a matter
// of the motion between the nodes (flight_boundaries.hpp, contact_boundaries.hpp,
// release_boundaries.hpp).
#pragma once

#include <optional>
#include <vector>

#include "graze/bifurcation/problem/orbit_branch.hpp"

namespace graze {

// A point or special point met along a branch.
struct BranchPlace {
  OrbitBranchPoint at;
  std::optional<SpecialPoint> special{};
  bool listed = true;  // is an orbit, or is wanted all the same
  // Of a branch that ends here.
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  bool begins = false;  // a part of other orbits begins here
  // Orbits that the special point leads to, or what leads to these.
  std::vector<OrbitBranchPoint> others{};
};

// A solution and what it is.
struct JudgedPoint {
  const SolutionPoint& point;
  const BranchPlace& place;
};

// How a branch ends beyond the last of its orbits.
struct BranchTip {
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  std::optional<BranchPlace> place{};  // in place of the trace's last point
};

// May remember what it was asked last: one thread at a time.
class BranchBoundaries {
 public:
  virtual ~BranchBoundaries() = default;

  // Whether a solution is to be listed: an orbit of the system, or all solutions are asked for.
  virtual bool lists(const SolutionPoint& solution) const = 0;
  // Whether the branch is to be traced on beyond `here`, and whether a step shows what happens
  // within it.
  virtual bool goes_on(const SolutionPoint& previous, const SolutionPoint& here) = 0;
  virtual bool resolves(const SolutionPoint& /*from*/, const SolutionPoint& /*to*/) { return true; }

  // Adds the places strictly between two neighbours, in order.
  virtual void pass(const JudgedPoint& a, const JudgedPoint& b,
                    std::vector<BranchPlace>& places) = 0;
  // Where the trace was halted or no step led on: cuts it off at the boundary there. Nothing where
  // the trace's own end says it all.
  virtual std::optional<BranchTip> close(Branch& /*trace*/, std::size_t /*side*/) { return {}; }
  // The orbit that a grazing leads to on its other side, as it is at the grazing.
  virtual std::optional<Orbit> across(const SpecialPoint& /*special*/) const { return {}; }
};

}  // namespace graze
