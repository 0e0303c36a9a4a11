// What the orbits along a locus are, and where they cease to be that: of flights that are
// prescribed (flight_locus.hpp) or of segments that are followed (segment_locus.hpp).
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "graze/bifurcation/cut/detail/locus_parts.hpp"

namespace graze {

// A solution on a locus.
struct LocusSite {
  Vector u;  // of the orbit
  double first = 0.0, second = 0.0;
  double angle = 0.0;  // of the critical multiplier, rad
  Vector further{};    // unknowns of the curve besides
};

// One thread at a time.
class LocusOrbits {
 public:
  virtual ~LocusOrbits() = default;

  // `zero`: the margin that vanishes there, where one does. Nothing where the motion is no orbit of
  // this layout.
  virtual std::optional<LocusPlace> place(const LocusSite& at,
                                          std::optional<LocusMargin> zero) const = 0;
  // Says what its orbits have in common.
  virtual ImpactPattern pattern(const std::vector<LocusPlace>& places) const = 0;

  // Of what has to stay positive, by LocusMargin; empty where the trace is halted instead, nothing
  // where they are not known.
  virtual std::optional<Vector> margins(const LocusSite& /*at*/) const { return Vector(); }
  // Whether a step shows what happens within it, and whether the locus goes on.
  virtual bool resolves(const LocusSite& /*from*/, const LocusSite& /*to*/) const { return true; }
  virtual bool goes_on(const LocusSite& /*previous*/, const LocusSite& /*here*/) const {
    return true;
  }
  // How it ends between neighbours of which only the inner one belongs to it, and at the last one
  // where no step led on.
  virtual OrbitLocusEnd end_between(const LocusSite& /*inner*/, const LocusSite& /*outer*/) const {
    return OrbitLocusEnd::kGrazing;
  }
  virtual OrbitLocusEnd end_at(const LocusSite& /*last*/) const {
    return OrbitLocusEnd::kNotConverged;
  }

  // To what the equations can be solved, and how long a locus may get.
  double tolerance = 1e-11;
  int most_points = kMostBranchPoints;
  void limit(LocusOptions& options) const {
    options.residual_tolerance = tolerance;
    options.max_points = std::min(options.max_points, most_points);
  }
};

}  // namespace graze
