// Loci of grazing of orbits that are followed: the curves in the plane of two parameters along
// which an orbit touches a stop at no speed, by the equations of segment_equations.hpp, in the
// unknowns u, one parameter and psi, over the other. Beside a grazing contact of a compliant stop
// the slope of the map has a root's singularity, or jumps where the force does; but what a step of
// Newton's method along a locus meets of it is in proportion to the depth, which the equations hold
// at zero to first order, so that either side serves.
#pragma once

#include "graze/bifurcation/loci/detail/orbit_curve.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

class SegmentGrazing : public OrbitCurve {
 public:
  // Of orbits that touch this stop, in (u, first/range, psi). The orbit has no
  // multipliers here: those of one that touches are those of either side.
  SegmentGrazing(const SegmentEquations& equations, int stop);

  std::vector<SolutionPoint> rewritings(const SolutionPoint& point) const override;
};

}  // namespace graze
