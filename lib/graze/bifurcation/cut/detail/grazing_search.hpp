// Where a branch of orbits that are followed grazes: the orbit that touches a stop at zero speed,
//
//   f(x_i) = x_{i+1},   b.q - a = 0,   b.q' = 0   at the forcing angle psi after the start of x_1,
//
// in the unknowns x_1, .., x_p, psi and the parameter, by Newton's method. The gap at psi passes
// zero with a nonzero rate, so that the solution depends neither on the step that passed it nor on
// the range, whereas the slope of the stroboscopic map has a square-root singularity there, or a
// jump.
#pragma once

#include <optional>

#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

struct FoundGrazing {
  SolutionPoint at;        // on the branch, its tangent turned along it
  GrazingContact contact;  // in that orbit
};

// The grazing of a stop between two neighbours on a branch; the nearer to `a` where there are
// several. Returns nullopt when Newton's method finds none between them.
std::optional<FoundGrazing> find_grazing_between(const SegmentEquations& equations,
                                                 const ContinuationOptions& options,
                                                 const SolutionPoint& a, const SolutionPoint& b,
                                                 int stop);

// The nearest grazing contact of an orbit beside a solution: an impact of the solution, or an
// approach that would be one. Its tangent may have either direction. Returns nullopt when Newton's
// method finds none near that.
std::optional<FoundGrazing> find_grazing_from(const SegmentEquations& equations,
                                              const ContinuationOptions& options,
                                              const SolutionPoint& from);

}  // namespace graze
