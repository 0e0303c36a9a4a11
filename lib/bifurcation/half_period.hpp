// Orbits of half the period on a branch of orbits.
//
// An orbit of half the period solves the equations of the whole one, too: what its second half
// differs from its first by is zero. Along a branch that difference passes zero there and comes out
// the other way round; beyond are the same orbits again, half a period later.
#pragma once

#include <algorithm>

#include "graze/base/vector.hpp"

namespace graze {

// Whether the difference of the halves, at two neighbours, turns round between them. Not where
// either is no larger than `rounding`, which says nothing, or empty, as where no orbit has half the
// period.
inline bool turns_round(const Vector& before, const Vector& now, double rounding) {
  return before.size() > 0 && before.size() == now.size() &&
         std::min(before.norm(), now.norm()) > rounding && before.dot(now) < 0.0;
}

}  // namespace graze
