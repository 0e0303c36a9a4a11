// Numbers whose exponent is kept apart: a product of many factors neither overflows nor vanishes on
// the way.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

namespace graze {

// mantissa 2^exponent; the mantissa's modulus near 1, or zero.
template <class Mantissa>
struct Scaled {
  Mantissa mantissa;
  long exponent = 0;

  void times(const Mantissa& factor) {
    mantissa *= factor;
    const double size = std::abs(mantissa);
    if (!(size > 0.0) || !std::isfinite(size)) return;
    const int shift = std::ilogb(size);
    mantissa *= std::ldexp(1.0, -shift);
    exponent += shift;
  }
  Mantissa value() const {
    // In two halves: either may be out of range where their product is not.
    const int e = static_cast<int>(std::clamp(exponent, -4000L, 4000L));
    return mantissa * std::ldexp(1.0, e / 2) * std::ldexp(1.0, e - e / 2);
  }
};

}  // namespace graze
