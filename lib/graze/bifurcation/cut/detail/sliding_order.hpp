// In which order friction slides and sticks along an orbit, and what it is called where that
// changes along a branch (M. di Bernardo et al., Piecewise-smooth Dynamical Systems, 2008, ch. 8).
#pragma once

#include "graze/bifurcation/problem/orbit_branch.hpp"

namespace graze {

// Whether both orbits have the same events of friction in the same order, whichever comes first
// after the section.
bool has_same_sliding(const Orbit& a, const Orbit& b);

// The change at which the shortest piece of sliding or sticking of this orbit begins to exist.
SpecialKind kind_of_change(const Orbit& orbit);

// The change that an orbit is about to have: where sliding ends with a speed that hardly falls, it
// is about not to end there; a piece that hardly lasts is about to vanish. nullopt: neither.
std::optional<SpecialKind> what_hardly_lasts(const Orbit& orbit);

}  // namespace graze
