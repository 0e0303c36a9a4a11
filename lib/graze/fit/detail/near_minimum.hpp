// Comes near the minimum of a sum of squares, by NLopt.
#pragma once

#include <functional>
#include <string>

#include "graze/fit/detail/least_squares_problem.hpp"

namespace graze {

struct NearMinimumOptions {
  bool global = false;         // search the whole box first
  long long evaluations = 0;   // at most; the box takes half of them
  std::function<bool()> over;  // whether to stop
};

struct NearMinimum {
  Vector parameters, residuals;  // the best found; empty when nothing could be evaluated
  std::string method;            // in words
};

// `residuals` replace those of the problem.
NearMinimum near_minimum(const LeastSquaresProblem& problem, const Residuals& residuals,
                         const NearMinimumOptions& options);

// The minimum itself where the sum of squares has kinks, by Nelder and Mead's simplex with initial
// sizes `deviations` around `at`, down to `part` of them. `residuals_at`: those at `at`.
NearMinimum simplex_minimum(const LeastSquaresProblem& problem, const Residuals& residuals,
                            const Vector& at, const Vector& residuals_at, const Vector& deviations,
                            double part, const std::function<bool()>& over);

}  // namespace graze
