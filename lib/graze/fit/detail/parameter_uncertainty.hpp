// How well the data determine the parameters of a fit, and warnings about its residuals.
#pragma once

#include <string>
#include <vector>

#include "graze/fit/detail/least_squares.hpp"
#include "graze/fit/fit_result.hpp"

namespace graze {

// The 97.5 % quantile of Student's distribution; of the normal one for `freedom` 0.
double confidence_quantile(long long freedom);

// Fills in uncertainties, intervals and correlations of `result` from the derivative at the
// optimum; parameters at limits are held. When the data do not determine a direction of the others,
// the result ends as kNotDetermined with a sentence, and the parameters that take part in it have
// no uncertainty.
void judge_parameters(const LeastSquaresResult& solved, FitResult& result);

// Adds warnings: known uncertainties that the residuals contradict, correlated residuals,
// parameters on their limits or with uncertainties as large as these.
void judge_residuals(const Vector& residuals, FitResult& result);

}  // namespace graze
