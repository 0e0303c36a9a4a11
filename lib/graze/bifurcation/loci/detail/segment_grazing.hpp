// Loci of grazing of orbits that are followed: the curves in the plane of two parameters along
// which an orbit touches a stop at zero speed, by the equations of segment_equations.hpp, in the
// unknowns u, one parameter and psi, over the other. Beside a grazing contact of a compliant stop
// the slope of the map has a square-root singularity, or jumps where the force does; but along a
// locus its effect on a step of Newton's method is proportional to the depth, which the equations
// keep zero to first order, so that either side can be used.
#pragma once

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

class SegmentGrazing : public OrbitCurve {
 public:
  // For orbits that touch this stop, in (u, first/range, psi). They have no multipliers here: these
  // differ on the two sides of the grazing.
  SegmentGrazing(const SegmentEquations& equations, int stop);

  std::vector<SolutionPoint> rewritings(const SolutionPoint& point) const override;
};

}  // namespace graze
