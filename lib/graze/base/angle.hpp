// Angles, rad.
#pragma once

#include <cmath>
#include <numbers>

namespace graze {

inline constexpr double kTurn = 2.0 * std::numbers::pi;

// An angle within a turn of zero with the sine and cosine of `theta`, to their last digits: what is
// far away is brought back by the library's own reduction.
template <class Real>
Real near_zero(const Real& theta) {
  using std::atan2, std::cos, std::sin;
  return theta > kTurn || theta < -kTurn ? Real(atan2(sin(theta), cos(theta))) : theta;
}

// The angle in [0, 2 pi) that differs from `theta` by whole turns.
inline double wrapped(double theta) {
  const double phase = std::fmod(theta, kTurn);
  if (phase >= 0.0) return phase;
  // -1e-17 plus a turn rounds to the turn itself.
  return phase + kTurn < kTurn ? phase + kTurn : 0.0;
}

}  // namespace graze
