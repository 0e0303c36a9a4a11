// Points within the steps of a branch, as many as it takes to see how its multipliers move.
//
// The course of the crossing tests (crossing_tests.hpp) between neighbouring points is the cubic
// through four of them; what it misses is told by the fourth divided difference, through a fifth. A
// piece between two points is clear where no test can have changed sign and changed it back within
// that error; any other is divided where this is most in doubt. So fast multipliers are sampled as
// densely as they move, and a pair of crossings within a step is met by the point that lies between
// them.
#pragma once

#include <vector>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

// For each step of the branch the points to be looked at within it, in order, their multipliers
// (without errors) with them. Requires multipliers, of the same number, at all points.
std::vector<std::vector<SolutionPoint>> crossing_samples(const Branch& branch,
                                                         const ZeroProblem& problem,
                                                         Corrector& corrector,
                                                         const StopSignal& stop);

}  // namespace graze
