// The response of one mode to the harmonic force, from rest.
#pragma once

#include "graze/flow/exact/detail/mode_flow.hpp"

namespace graze {

// Response from rest to the harmonic force and its rate, divided by the modal force: the solution
// of x'' + 2 delta x' + w^2 x = cos(theta + W s) that starts at rest. Relative to the bound of its
// size, s^2 over (1 + delta s + w^2 s^2), it is accurate to rounding for every mode and frequency.
template <class Real>
PlanarNumber<Real> forced_response(const ModeFlow<Real>& mode, const Real& frequency,
                                   const Real& theta, const Real& s);

}  // namespace graze
