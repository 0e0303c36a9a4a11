// Points within the steps of a branch, as many as needed to see how its multipliers move.
//
// Between neighbouring points each crossing test (crossing_tests.hpp) is approximated by the cubic
// through four of them; its error is estimated by the fourth divided difference, through a fifth. A
// piece between two points is clear when no test can have changed sign and back within that error;
// any other piece is divided where this is most likely. So fast multipliers are sampled more
// densely, and a pair of crossings within a step is separated by a point between them.
#pragma once

#include <vector>

#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

// For each step of the branch the sampling points within it, in order, with their multipliers
// (without errors). Requires multipliers, of the same number, at all points.
std::vector<std::vector<SolutionPoint>> crossing_samples(const Branch& branch,
                                                         const ZeroProblem& problem,
                                                         Corrector& corrector,
                                                         const StopSignal& stop);

}  // namespace graze
