// What no motion does whose stops are passive, looked at along every motion: a comparison an event,
// of numbers that are at hand. What fails it is looked at closely, against the roundings of what
// was compared, and ends the motion: a program that is right never fails here, and one that is
// wrong is told apart from a motion that is surprising.
//
//   an open stop is not passed:     gap >= 0 at the end of a flight that began with gap >= 0;
//   a contact does not pull:        force >= 0 after an event, but of springs let go at the
//   surface; an impact does not add energy:  q'+.M q'+ <= q'-.M q'-  where one coefficient 0 <= r
//   <= 1 and
//                                   the momentum law hold at all stops that are hit.
//
// A spring adds none then: it begins at its surface, where it stores nothing, and its damping takes
// C T(x) v^2 >= 0.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace graze {

// Roundings of the motion's own numbers count so often in what it is formed from: it is written
// about a forced response that is up to 2^12 times as large (exact_flow_impl.hpp).
inline constexpr double kAuditAmplification = 0x1p12;

// Whether a gap, m, was passed in a flight, beyond its rounding.
template <class Real>
bool passes(const Real& before, const Real& after, const Real& rounding) {
  return after < -rounding && !(before < -rounding);
}

// Whether an impact added to q'.M q' of n modes. `size`: of the velocities that it is formed from,
// |q'-| and all impulses. Rounded are two sums of squares, n + 1 each; the speeds that the impulses
// go by, n + 2 with the factor 2 of a square; and the impulses' own products, ten.
template <class Real>
bool adds_energy(const Real& before, const Real& after, const Real& size, Eigen::Index n) {
  const Real roundings = 4 * static_cast<double>(n) + 16;
  return after - before > roundings * std::numeric_limits<Real>::epsilon() * size * size;
}

}  // namespace graze
