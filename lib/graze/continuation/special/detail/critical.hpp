// Special points of a traced branch that its tangents do not show: branch points from its
// orientation, period doublings and tori from its multipliers.
//
// The latter two are found from the multipliers at points within each step, as many as needed to
// see every crossing (crossing_samples.hpp, circle_crossings.hpp). Branch points are located as
// regular solutions of a larger system.
#pragma once

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

// Adds them to branch.critical, which holds the folds, and sorts all along the branch. When `stop`
// is requested, only those found so far.
void add_critical_points(Branch& branch, const ZeroProblem& problem, Corrector& corrector,
                         const StopSignal& stop);

}  // namespace graze
