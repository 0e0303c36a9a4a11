// Functions of all multipliers of a solution that change sign where some of them cross the unit
// circle, and are smooth along a branch even where multipliers meet and part:
//
//   flip  = prod g(1 + mu_i),   fold = prod g(1 - mu_i),   torus = prod_{i<j} g(1 - mu_i mu_j),
//   g(x) = x/sqrt(|x|^2 + c^2)
//
// (the torus function vanishes at neutral saddles, mu_i mu_j = 1, too). Through g a factor counts
// only where it is small: neither a multiplier that diverges beside a grazing nor the number of
// modes lets the products diverge. They show where within a step to search for crossings that its
// ends do not show; the kind of a crossing is decided by the multipliers themselves.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"

namespace graze {

struct CrossingTest {
  int sign = 1;
  double log_size = 0.0;  // of its modulus; -infinity where it vanishes
  bool known = true;      // no factor is within its rounding error of zero

  double value() const { return sign * std::exp(log_size); }
};

// Flip, fold, torus.
inline constexpr std::size_t kCrossingTests = 3;
inline constexpr std::size_t kFlip = 0, kFoldTest = 1;
using CrossingTests = std::array<CrossingTest, kCrossingTests>;

CrossingTests crossing_tests(const std::vector<Eigenvalue>& multipliers);

}  // namespace graze
