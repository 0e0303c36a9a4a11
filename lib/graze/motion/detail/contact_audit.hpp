// Conditions that every motion with passive stops fulfils, checked along every motion: one
// comparison of known numbers per event. When one fails it is checked closely, against the rounding
// of the numbers compared, and then ends the motion. A correct program never fails here, so that a
// failure shows an error of the program and not an unusual motion.
//
//   an open stop is not passed:     gap >= 0 at the end of a flight that began with gap >= 0;
//   a contact does not pull:        force >= 0 after an event, except at springs let go at their
//                                   surface;
//   an impact does not add energy:  q'+.M q'+ <= q'-.M q'-  where one coefficient 0 <= r <= 1 and
//                                   the momentum law hold at all stops that are hit.
//
// A spring adds none then: it begins at its surface, where it stores nothing, and its damping takes
// C T(x) v^2 >= 0.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace graze {

// Factor on the rounding of a motion's numbers: they are written about a forced response that is up
// to 2^12 times as large (exact_flow_impl.hpp).
inline constexpr double kAuditAmplification = 0x1p12;

// Whether a gap, m, was passed in a flight, beyond its rounding.
template <class Real>
bool passes(const Real& before, const Real& after, const Real& rounding) {
  return after < -rounding && !(before < -rounding);
}

// Whether an impact added to q'.M q' of n modes. `size`: of the velocities that it is formed from,
// q'-| and all impulses. Rounding comes from two sums of squares, n + 1 each; from the speeds that
// decide the impulses, n + 2 with the factor 2 of a square; and from the impulses' own products,
// ten.
template <class Real>
bool adds_energy(const Real& before, const Real& after, const Real& size, Eigen::Index n) {
  const Real roundings = 4 * static_cast<double>(n) + 16;
  return after - before > roundings * std::numeric_limits<Real>::epsilon() * size * size;
}

}  // namespace graze
