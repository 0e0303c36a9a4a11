// Stable orbits that motions from a spread of starts settle on and that a search has not found,
// whatever their number of impacts.
//
// Starts are points of a Sobol sequence, moved by the seed: at each stop the static deflection
// under a force there and a velocity of that shape, up to twice the system's scale either way from
// the steady response. Each motion is followed until it repeats, or has come within 1e-3 (phases in
// rad, speeds in units of the forced motion) of an orbit that is known and stable; a new repetition
// is solved for. The work is counted in impacts and forcing periods, so that the result depends on
// no clock.
#pragma once

#include "graze/orbit/search/finder_values.hpp"

namespace graze {

inline constexpr int kSpreadStarts = 128;

// Budget of impacts and forcing periods for all these motions together, with rigid stops and with
// compliant ones, where each costs some fifty times as much: no more time than the other searches.
inline constexpr long long kSpreadWork = 40960, kSprungSpreadWork = 1024;

// Adds the stable orbits that such motions settle on, if the options ask for them, and a note on
// the outcome of all starts when an orbit is new. Fewer starts are followed when `most_work`
// impacts and forcing periods are used up. Requires forcing and a stop.
void add_settled_orbits(const System& system, const FinderOptions& options, long long most_work,
                        FoundOrbits& found);

}  // namespace graze
