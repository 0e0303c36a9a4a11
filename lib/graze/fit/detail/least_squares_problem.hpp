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
  // Parameters that span more than a decade are sought by their logarithms (1), others (0) as they
  // are; n.
  std::vector<bool> logarithmic{};
  bool linear = false;  // r is linear in p: Gauss and Newton's step is the solution
  double size = 1.0;    // |measured/uncertainty|: what r is rounded against
  double noise = 0.0;   // of one residual where it is known (1); 0: from the residuals
};

}  // namespace graze
