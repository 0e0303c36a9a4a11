// Where between two solutions of the shooting equations, one an orbit and one not, the solutions
// stop being orbits of the system: at a border.
#pragma once

#include <optional>

#include "graze/bifurcation/grazing_stations.hpp"

namespace graze {

struct OrbitBorder {
  OrbitBranchPoint at;
  // An approach touches there, an impact speed vanishes, or an impact that leaves its stop at rest
  // is pushed back; nothing where two impacts come together instead.
  std::optional<SpecialPoint> grazing;
};

// The border between neighbours a and b. Nothing where it cannot be located.
std::optional<OrbitBorder> border_between(const OrbitEquations& equations,
                                          const ContinuationOptions& options, const SeenSolution& a,
                                          const SeenSolution& b);

}  // namespace graze
