// Periodic orbits of structures on compliant stops: x_1 -> x_2 -> .. -> x_p -> x_1 under the
// stroboscopic map (strobe_map.hpp), all x_i unknown, by Newton's method with its derivatives.
// The multipliers are the eigenvalues of the product of the slopes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/orbit/orbit.hpp"
#include "graze/orbit/strobe_map.hpp"

namespace graze {

struct StrobeAnswer {
  std::optional<Orbit> orbit;  // minimal, with contacts
  std::string why_not;         // a sentence where there is none
};

// The orbit near the motion that starts at `at_period_start` (t = 0) and repeats after `period`
// forcing periods. Requires forcing.
StrobeAnswer strobe_orbit(const System& system, const State& at_period_start, int period,
                          const StrobeOptions& options);

// The orbit of a solution u = (x_1, .., x_p) of the map. No orbit without any impact, where a rigid
// stop is stuck to, or where the motion cannot be followed. `residual`: of the solution.
std::optional<Orbit> orbit_of(const System& system, const StrobeMap& map, const Vector& u,
                              std::vector<Eigenvalue> multipliers, double residual);

}  // namespace graze
