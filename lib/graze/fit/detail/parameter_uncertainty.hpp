// How well the data determine the parameters of a fit, and what in its residuals deserves a word.
#pragma once

#include <string>
#include <vector>

#include "graze/fit/detail/least_squares.hpp"
#include "graze/fit/fit_result.hpp"

namespace graze {

// The 97.5 % quantile of Student's distribution; of the normal one for `freedom` 0.
double confidence_quantile(long long freedom);

// Fills in uncertainties, intervals and correlations of `result` from the derivative at the
// optimum; parameters at limits are held. Where a direction of the others is not told by the data,
// the result ends as kNotDetermined with a sentence, and those that take part in it have no
// uncertainty.
void judge_parameters(const LeastSquaresResult& solved, FitResult& result);

// Adds warnings: known uncertainties that the residuals contradict, residuals that follow one
// another, parameters on their limits or known no better than these.
void judge_residuals(const Vector& residuals, FitResult& result);

}  // namespace graze
