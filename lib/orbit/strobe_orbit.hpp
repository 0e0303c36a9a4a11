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
                          const PassageOptions& options);

// The orbit near one with these states at the starts of its forcing periods, where the section of
// the map lies.
StrobeAnswer strobe_orbit(const System& system, const std::vector<State>& turns,
                          const PassageOptions& options);

// The orbit of a solution u = (x_1, .., x_p) of the map. No orbit without any impact, where a rigid
// stop is stuck to, or where the motion cannot be followed. `residual`: of the solution.
std::optional<Orbit> orbit_of(const System& system, const StrobeMap& map, const Vector& u,
                              std::vector<Eigenvalue> multipliers, double residual);

// The states at the starts of its forcing periods; requires an orbit on compliant stops.
std::vector<State> turns_of(const Orbit& orbit);

// An instant at which an orbit touches a compliant stop at no speed.
struct StrobeTouch {
  int stop = 0;
  std::size_t turn = 0;  // of the orbit's
  double angle = 0.0;    // of the forcing, after the turn's start, rad, 0 <= angle < 2 pi
  // m/s: a contact at that instant which begins no faster is the touch itself, met a little deep.
  double slowest = 0.0;
};

// Where the orbit of a solution, or of one near that, comes near to a touch: its contacts, and the
// least gap of each of its turns, the nearest first, told by v^2/2 as the depth in units of the
// forced motion. Empty where there is neither, or where the motion cannot be followed.
std::vector<StrobeTouch> touches_near(const System& system, const StrobeMap& map, const Vector& u);

// The first of them; nothing where there is none, or where that is a rigid stop's.
std::optional<StrobeTouch> nearest_touch(const System& system, const StrobeMap& map,
                                         const Vector& u);

// The orbit of a solution that has this touch, as an impact at speed 0 with a contact in which
// nothing happens. Without multipliers; nothing as above.
std::optional<Orbit> touching_orbit_of(const System& system, const StrobeMap& map, const Vector& u,
                                       const StrobeTouch& touch, double residual);

}  // namespace graze
