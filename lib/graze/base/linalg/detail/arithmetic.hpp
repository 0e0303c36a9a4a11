// What the decompositions of this folder calculate with.
#pragma once

#include <limits>

#include "graze/base/vector.hpp"

namespace graze {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The product without the tests for infinite parts that std::complex makes.
inline Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace graze
