// What an impact does to small deviations.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

// The saltation matrix of an impact: how a deviation just before it, at a fixed time, becomes one
// just after: S = J + (f+ - J f-) c^T/(c^T f-), with c the contact row and f the vector field.
Matrix saltation_matrix(const System& system, const Stop& stop, const State& before, double theta);

}  // namespace graze
