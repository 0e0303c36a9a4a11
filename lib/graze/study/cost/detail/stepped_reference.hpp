// The reference where no closed form is known: the same motion by two independent methods, an
// embedded Runge-Kutta pair of order 8 and extrapolation, as far as they agree.
#pragma once

#include "graze/study/cost/reference_run.hpp"

namespace graze {

// The reference has the instants of the first method, up to where those of the second differ by
// more than this, s; smaller errors of other flows are not known.
inline constexpr double kVouchedTime = 1e-11;

// For what is followed by steps (is_followed_by_steps).
ReferenceRun stepped_reference(const System& system, const State& start,
                               const ReferenceOptions& options);

}  // namespace graze
