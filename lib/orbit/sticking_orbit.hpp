// Periodic orbits that stick, or close a chatter.
//
// While m stops (with independent rows) are closed the motion has only N - m degrees of freedom,
// (q, q') = (q_c + U y, U y'). So a section is laid at a fixed phase theta_s within a stuck phase,
// and the orbit is a fixed point of the map over p periods on the 2(N - m) numbers (y, y'):
//
//   F(y, y') = P(y, y') - (y, y') = 0,        Newton's method with the analytic DP (passage.hpp).
//
// P is the motion itself, certified event by event, so a fixed point is admissible: gaps are clear
// between events, contact forces push while stuck. Its eigenvalues are the orbit's multipliers; the
// other 2m are zero, exactly: the held motion has forgotten what came before. With N = m there is
// nothing left to solve: the orbit is met by any start that sticks.
//
// The tail of a chatter below the closure speed v_c is summed: the accumulation time errs by
// O(v_c^2), state and multipliers by O(v_c^3), and the impacts are the resolved ones.
#pragma once

#include <optional>
#include <string>

#include "graze/orbit/orbit.hpp"
#include "graze/orbit/passage.hpp"

namespace graze {

struct StickingOrbitAnswer {
  std::optional<Orbit> orbit;  // minimal and admissible
  std::string why_not;         // a sentence where there is none
};

// The orbit near the motion that starts at `at_period_start` (t = 0) and repeats after `period`
// forcing periods. Requires forcing. The guess has to lie where Newton's method converges; a
// simulated motion that repeats to 1e-6 does.
StickingOrbitAnswer sticking_orbit(const System& system, const State& at_period_start, int period,
                                   const PassageOptions& options);

// The orbit that repeats, after `period` forcing periods, a motion that is known to do so, from a
// state within a stuck phase. Nothing is solved; its residual says how nearly it repeats. No orbit
// where the motion does not come back to that stuck phase.
StickingOrbitAnswer sticking_orbit_through(const System& system,
                                           const MotionState<double>& at_section, int period,
                                           const PassageOptions& options);

}  // namespace graze
