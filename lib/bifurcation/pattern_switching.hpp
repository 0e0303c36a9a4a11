// Where a branch of another impact pattern begins at a special point.
//
//   PD  every impact twice, two periods in one: the doubled orbits cross there.
//   BP  the same pattern: another branch crosses.
//   GR  an interior approach that touches becomes an impact at zero speed, or an impact whose speed
//       vanishes is left out. Contact is an equation of the shooting problem, so the orbits of the
//       new sequence pass through the grazing smoothly, at speed zero; on one side of it they
//       impact for real.
#pragma once

#include <optional>
#include <vector>

#include "graze/bifurcation/orbit_equations.hpp"

namespace graze {

struct PatternSwitch {
  ImpactPattern pattern;
  std::vector<ImpactPoint> impacts;  // of the orbit at the special point, in the new pattern
  // For PD and BP: the tangent of the branch that is known, in the new pattern's unknowns; the
  // other one is to be sought. Empty for GR, where one branch passes.
  Vector known_tangent;
};

// Nothing for a fold or a torus, and for a grazing that leaves no impact.
std::optional<PatternSwitch> pattern_switch(const OrbitEquations& equations,
                                            const SpecialPoint& special);

}  // namespace graze
