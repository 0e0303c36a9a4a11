// Grazings (GR) that end a branch of orbits that stick.
//
// On the side with the impact, the map's derivative grows like 1/v, and an impact of speed v
// penetrates by some v^2: when v is below the square root of the residual tolerance, orbits with
// and without the impact cannot be distinguished. A trace that comes near is not followed so far;
// the point of zero speed is solved for by the equations of a grazing contact, which are regular
// there (grazing_search.hpp).
#pragma once

#include "graze/bifurcation/cut/detail/release_tip.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

// Whether an approach touches a stop there.
bool touches(const SegmentEquations& equations, const SolutionPoint& at);

// The grazing there, where an impact or an approach touches; else no boundary. `is_lost`: the other
// side shows that it is an impact which is lost.
ReleaseTip grazing_at(const SegmentEquations& equations, const ContinuationOptions& options,
                      const SolutionPoint& at, bool is_lost);

// The grazing ahead of b as seen from a, if an impact has become slow on the way to b; with an
// orbit without that impact, if there is one near. No boundary if none has become slow.
ReleaseTip grazing_ahead(const SegmentEquations& equations, const ContinuationOptions& options,
                         const SolutionPoint& a, const SolutionPoint& b);

}  // namespace graze
