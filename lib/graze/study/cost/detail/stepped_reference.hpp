// What runs are compared with where no closed form is known: the same motion by two methods that
// have nothing in common, an embedded Runge-Kutta pair of order 8 and extrapolation, as far as they
// agree.
#pragma once

#include "graze/study/cost/reference_run.hpp"

namespace graze {

// The instants of the first, until those of the second differ by more than this, s; what other
// flows are told to err by less is not known.
inline constexpr double kVouchedTime = 1e-11;

// Of a structure on a hub.
ReferenceRun stepped_reference(const System& system, const State& start,
                               const ReferenceOptions& options);

}  // namespace graze
