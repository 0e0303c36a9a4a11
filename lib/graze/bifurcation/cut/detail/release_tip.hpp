// Where solutions of the equations of orbits that stick stop being orbits with the same events (a
// boundary), or where a branch of them ends (its tip).
#pragma once

#include <optional>

#include "graze/bifurcation/problem/orbit_branch.hpp"

namespace graze {

struct ReleaseTip {
  // CH, LO or GR at a boundary; "not converged" when it cannot be classified.
  OrbitBranchEnd end = OrbitBranchEnd::kNotConverged;
  std::optional<SolutionPoint> boundary;  // the special point there, where there is one
  bool by_speed = false;                  // of a grazing: an impact loses its speed
  bool interrupted = false;               // of CH and LO: a stuck phase is cut in two
  double value = 0.0;                     // of the parameter there
  std::optional<SolutionPoint> beyond;    // an orbit on the other side, if one was found
  Bracket bracket{};                      // of the boundary
};

}  // namespace graze
