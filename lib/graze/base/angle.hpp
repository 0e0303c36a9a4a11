// Angles, rad.
#pragma once

#include <cmath>
#include <numbers>

namespace graze {

inline constexpr double kTurn = 2.0 * std::numbers::pi;

// An angle within one revolution of zero with the sine and cosine of `theta`, to their last digits;
// a large `theta` is reduced by the library's own sine and cosine.
template <class Real>
Real near_zero(const Real& theta) {
  using std::atan2, std::cos, std::sin;
  return theta > kTurn || theta < -kTurn ? Real(atan2(sin(theta), cos(theta))) : theta;
}

// The angle in [0, 2 pi) that differs from `theta` by a multiple of 2 pi.
inline double wrapped(double theta) {
  const double phase = std::fmod(theta, kTurn);
  if (phase >= 0.0) return phase;
  // -1e-17 + 2 pi rounds to 2 pi itself.
  return phase + kTurn < kTurn ? phase + kTurn : 0.0;
}

}  // namespace graze
