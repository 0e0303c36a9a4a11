// One form of an impact pattern, and one order of its impacts, that do not depend on where the
// period begins.
#pragma once

#include <vector>

#include "graze/orbit/problem/detail/shooting.hpp"

namespace graze {

// The same pattern, starting with the impact that puts its stops first in lexicographic order.
ImpactPattern canonical(ImpactPattern pattern);

// The impacts of an orbit in the order of its canonical pattern.
std::vector<ImpactPoint> in_canonical_order(const ImpactPattern& pattern,
                                            std::vector<ImpactPoint> impacts);

// Pattern and impacts starting with another impact; those before it come a period later.
ImpactPattern turned(ImpactPattern pattern, std::size_t turn);
std::vector<ImpactPoint> turned(std::vector<ImpactPoint> impacts, std::size_t turn, int period);

// All cyclic relabellings of the impacts that keep the pattern, this order first.
std::vector<std::vector<ImpactPoint>> rewritings(const ImpactPattern& pattern,
                                                 const std::vector<ImpactPoint>& impacts);

}  // namespace graze
