// The effect of an impact on small deviations.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// The saltation matrix of an impact: how a deviation just before it, at a fixed time, becomes one
// just after: S = J + (f+ - J f-) c^T/(c^T f-), with c the contact row and f the vector field.
Matrix saltation_matrix(const System& system, const Stop& stop, const State& before, double theta);

// S - 1 = from to^T, of rank two: the columns of `to` give the gap at the instant of the impact,
// and the approach speed, of a deviation; 2N x 2 each.
struct SaltationFactors {
  Matrix from, to;
};
SaltationFactors saltation_factors(const System& system, const Stop& stop, const State& before,
                                   double theta);

}  // namespace graze
