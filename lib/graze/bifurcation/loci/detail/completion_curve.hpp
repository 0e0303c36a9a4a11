// Loci of CH: the curves in the plane of two parameters along which a chatter completes at the very
// instant at which its stop is released, by the distance of chatter_completion.hpp in the unknowns
// u of an orbit at that release and one parameter, over the other.
//
// The slope of that distance is computed by differences: Newton's method ends where the distance is
// zero, whatever the slope.
#pragma once

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

class CompletionCurve : public OrbitCurve {
 public:
  // For orbits at a release of the stop on which the chatter completes.
  explicit CompletionCurve(const SegmentEquations& equations);

 private:
  std::optional<double> distance(const Vector& y, double second) const;
  std::optional<Condition> condition(const Vector& y, double second) const;

  const SegmentEquations& segments_;
};

}  // namespace graze
