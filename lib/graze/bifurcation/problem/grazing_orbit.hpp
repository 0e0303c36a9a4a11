// An orbit that grazes, with its grazing contact as an impact at zero speed: a special point GR is
// the same whether it is reached before an approach touches or after an impact is born.
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

// The orbit whose nearest approach touches, with that as an additional impact in order. Returns
// nullopt when no gap has an interior minimum.
std::optional<GrazingOrbit> with_grazing(const System& system, const ImpactPattern& pattern,
                                         const std::vector<ImpactPoint>& impacts);

// The orbit without that impact; without any impacts if there was no other.
GrazingOrbit without_grazing(GrazingOrbit orbit);

}  // namespace graze
