// An eigenvalue and what rounding may have done to it.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include "graze/base/vector.hpp"

namespace graze {

// An eigenvalue and a bound on its rounding error, for a perturbation E of size eps n |A| or as
// said: the smallest of the first-order bound |E| times the eigenvalue's own condition number, of
// the one that several near 0 have together (triangular_factors.hpp), and of Elsner's
// (|A| + |E|)^(1 - 1/n) |E|^(1/n), which holds where the matrix is defective and the first is
// infinite.
struct Eigenvalue {
  Complex value;
  double error = 0.0;
  // The value as far as it is known: real where a perturbation of the size of the error can make it
  // meet its conjugate, as when rounding splits a double real eigenvalue. The two separate as the
  // square root of the perturbation, so twice the linear error reaches back to where they meet.
  Complex known() const {
    return std::abs(value.imag()) <= 2.0 * error ? Complex(value.real()) : value;
  }
};

// The one nearest to a number; the end of an empty list.
template <class List>
auto nearest_to(List& list, const Complex& value) {
  return std::min_element(list.begin(), list.end(), [&](const Eigenvalue& a, const Eigenvalue& b) {
    return std::abs(a.value - value) < std::abs(b.value - value);
  });
}

}  // namespace graze
