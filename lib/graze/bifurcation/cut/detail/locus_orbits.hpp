// The orbits along a locus, and where they end: of prescribed flights (flight_locus.hpp) or of
// segments that are followed (segment_locus.hpp).
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

// For one thread at a time.
class LocusOrbits {
 public:
  virtual ~LocusOrbits() = default;

  // `zero`: the margin that vanishes there, if one does. Returns nullopt when the motion is no
  // orbit of this layout.
  virtual std::optional<LocusPlace> place(const LocusSite& at,
                                          std::optional<LocusMargin> zero) const = 0;
  // The common impact pattern of its orbits.
  virtual ImpactPattern pattern(const std::vector<LocusPlace>& places) const = 0;

  // The quantities that have to stay positive, by LocusMargin; empty where the trace is halted
  // instead, nullopt when they are not known.
  virtual std::optional<Vector> margins(const LocusSite& /*at*/) const { return Vector(); }
  // Whether a step is short enough to show what happens within it, and whether the locus goes on.
  virtual bool resolves(const LocusSite& /*from*/, const LocusSite& /*to*/) const { return true; }
  virtual bool goes_on(const LocusSite& /*previous*/, const LocusSite& /*here*/) const {
    return true;
  }
  // How it ends between neighbours of which only the inner one belongs to it, and at the last point
  // when no step succeeded.
  virtual OrbitLocusEnd end_between(const LocusSite& /*inner*/, const LocusSite& /*outer*/) const {
    return OrbitLocusEnd::kGrazing;
  }
  virtual OrbitLocusEnd end_at(const LocusSite& /*last*/) const {
    return OrbitLocusEnd::kNotConverged;
  }

  // Tolerance of the equations, and largest number of points of a locus.
  double tolerance = 1e-11;
  int most_points = kMostBranchPoints;
  void limit(LocusOptions& options) const {
    options.residual_tolerance = tolerance;
    options.max_points = std::min(options.max_points, most_points);
  }
};

}  // namespace graze
