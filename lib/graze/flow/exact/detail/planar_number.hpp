// A complex number; std::complex promises nothing for extended scalars.
#pragma once

namespace graze {

template <class Real>
struct PlanarNumber {
  Real re = 0;
  Real im = 0;

  friend PlanarNumber operator*(const PlanarNumber& a, const PlanarNumber& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend PlanarNumber operator/(const PlanarNumber& a, const PlanarNumber& b) {
    const Real norm = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / norm, (a.im * b.re - a.re * b.im) / norm};
  }
};

}  // namespace graze
