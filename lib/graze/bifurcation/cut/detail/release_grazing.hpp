// Grazings (GR) that end a branch of orbits that stick.
//
// Seen from the side on which it impacts, the map's derivative grows like 1/v, and an impact of
// speed v reaches behind the stop by some v^2: below the root of what residuals are solved to, an
// orbit with the impact and one without cannot be told apart. A trace that comes near is not
// followed so far; where the speed vanishes is solved for by the equations of a grazing contact,
// which are regular there (grazing_search.hpp).
#pragma once

#include "graze/bifurcation/cut/detail/release_tip.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

// Whether an approach touches there.
bool touches(const SegmentEquations& equations, const SolutionPoint& at);

// The grazing there, where an impact or an approach touches; else no boundary. `is_lost`: an impact
// is, by what is known of the other side.
ReleaseTip grazing_at(const SegmentEquations& equations, const ContinuationOptions& options,
                      const SolutionPoint& at, bool is_lost);

// The grazing that lies ahead of b as seen from a, where an impact has become slow on the way to b;
// and an orbit without that impact, if there is one near. No boundary where none has.
ReleaseTip grazing_ahead(const SegmentEquations& equations, const ContinuationOptions& options,
                         const SolutionPoint& a, const SolutionPoint& b);

}  // namespace graze
