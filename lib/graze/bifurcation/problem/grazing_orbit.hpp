// An orbit that grazes, with the impact at zero speed that its grazing contact is: a special point
// GR seen from either side, before an approach touches or after an impact was born, is one and the
// same.
#pragma once

#include <optional>
#include <vector>

#include "graze/orbit/problem/orbit.hpp"

namespace graze {

struct GrazingOrbit {
  ImpactPattern pattern;
  std::vector<ImpactPoint> impacts;
  std::size_t grazing = 0;  // the impact that has no speed
};

// The orbit whose nearest approach touches, with that as an impact after the one it follows.
// Nothing where no gap has an interior minimum.
std::optional<GrazingOrbit> with_grazing(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& impacts);

// The orbit without that impact; with no impacts at all where there was no other.
GrazingOrbit without_grazing(GrazingOrbit orbit);

}  // namespace graze
