// The derivative of a motion by a parameter as a deviation that grows along an arc, free or held;
// the parameter moves the system along its tangent.
//
// It is carried like the deviations of deviation.hpp, with the forcing phase as the clock: the two
// motions are compared at phases that differ by frequency times the delay, so that a parameter that
// moves the frequency moves the lengths of the arcs and nothing else.
#pragma once

#include <vector>

#include "graze/flow/variation/detail/deviation.hpp"

namespace graze {

struct ParameterGrowth {
  Deviations change;  // one column
  Vector moved;       // q at the end less q at the start, kg^1/2 m; accurate relative to itself
};

// Growth of the deviation `column` (one column, unchanged delay) over s seconds of the arc on which
// `phase` was started from `start` at forcing phase theta. Requires forcing. The deviation of a
// held phase has to satisfy the constraints of its closed stops (see `hold`).
ParameterGrowth parameter_growth(const System& system, const System& tangent,
                                 const ExactPhase<double>& phase, const State& start, double theta,
                                 double s, const Deviations& column);

// As `hold` of deviation.hpp for the deviation by a parameter: closed stops move with their rows
// and gaps, b.dq = da - db.q and b.dq' = -db.q'.
void hold(const System& system, const System& tangent, const std::vector<int>& closed,
          const State& state, Deviations& column);

}  // namespace graze
