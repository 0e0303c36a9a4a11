// Angles, rad.
#pragma once

#include <cmath>
#include <numbers>

namespace graze {

inline constexpr double kTurn = 2.0 * std::numbers::pi;

// The angle in [0, 2 pi) that differs from `theta` by whole turns.
inline double wrapped(double theta) {
  const double phase = std::fmod(theta, kTurn);
  if (phase >= 0.0) return phase;
  // -1e-17 plus a turn rounds to the turn itself.
  return phase + kTurn < kTurn ? phase + kTurn : 0.0;
}

}  // namespace graze
