// Special points of a traced branch that its tangents do not show: branch points from its
// orientation, period doublings and tori from its multipliers.
//
// The latter two are read off the multipliers at points within each step, so many that every
// crossing is seen (crossing_samples.hpp, circle_crossings.hpp). Branch points are located as
// regular solutions of a larger system.
#pragma once

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

// Adds them to branch.critical, which holds the folds, and puts all in order along the branch.
// Those found so far where `stop` asks for it.
void add_critical_points(Branch& branch, const ZeroProblem& problem, Corrector& corrector,
                         const StopSignal& stop);

}  // namespace graze
