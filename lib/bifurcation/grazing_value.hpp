// Where a branch grazes, from solutions before it.
#pragma once

#include <optional>
#include <vector>

namespace graze {

// A solution near a grazing: its parameter, and what vanishes there, a gap (m) or a speed (m/s).
struct NearGrazing {
  double parameter = 0.0, margin = 0.0;
};

// The parameter where the margin is zero, by the polynomial through solutions at margins that grow
// by 1.3 at least, from `reliable` on (five at most, from two on). Seen from the side on which the
// margin is positive the parameter is a smooth function of it; where the motion does not feel the
// impact whose speed it is, one without a linear term. `solutions`: the nearest to the grazing
// last. Nothing where fewer are at hand.
std::optional<double> grazing_value(const std::vector<NearGrazing>& solutions, double reliable);

}  // namespace graze
