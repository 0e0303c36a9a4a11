// Parameters within limits for which a sum of squares |r(p)|^2 is to be least.
#pragma once

#include <functional>
#include <vector>

#include "graze/fit/detail/difference_jacobian.hpp"

namespace graze {

struct LeastSquaresProblem {
  Residuals residuals;
  std::function<Matrix(const Vector&)> jacobian{};  // empty: not in closed form
  Vector start, low, high;  // n; start within the limits, limits finite unless it is linear
  // Whether a parameter is fitted by its logarithm, as one that spans more than a decade; n.
  std::vector<bool> logarithmic{};
  bool linear = false;  // r is linear in p: one Gauss-Newton step is the solution
  double size = 1.0;    // measured/uncertainty|, which sets the rounding of r
  double noise = 0.0;   // of one residual where it is known (1); 0: from the residuals
};

}  // namespace graze
