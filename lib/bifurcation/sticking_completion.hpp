// Where the stuck phases of an orbit change: CH, where one of them shrinks to nothing or is cut in
// two, and LO, where the only one has grown to all of the period.
//
// A stuck phase shrinks as the distance to CH to the power 3/5; where a contact force touches zero
// the stop is open for a time that goes as the root of the distance (sticking_branches.hpp). Both
// are followed to what 1e-10 of the parameter leaves of them.
#pragma once

#include <optional>
#include <utility>

#include "graze/bifurcation/passage_equations.hpp"
#include "graze/bifurcation/sticking_approach.hpp"
#include "graze/bifurcation/sticking_tip.hpp"

namespace graze {

// Whether a stuck phase of the motion has shrunk to nothing. `period` of the forcing, s.
bool has_shrunk(const ReleaseReturn& back, double period);

// The CH or LO at the border that was approached; none where the border is something else, or
// cannot be told to the last digits.
StickingTip completion(const PassageEquations& equations, const StickingApproach& approach);

// Where the force that holds the structure at rest touches zero, as the value of the parameter and
// the phase, rad. Flights near that are too short to tell from none; the force is smooth across it.
// `near` is a value within what they tell; nothing where the force does not vanish there. `range`:
// of the parameter.
std::optional<std::pair<double, double>> lift_off(const PassageEquations& equations, double range,
                                                  double near);

}  // namespace graze
