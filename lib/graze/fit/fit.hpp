// Parameters of a scene from measurements: the values for which the sum of squares of what was
// measured less what the scene says, each in units of its uncertainty, is least, and how well the
// data determine them.
//
//   covariance   s^2 (J^T J)^-1,   s^2 = sum of squares/(m - n)
//   interval     value -+ t s_j,   t the 97.5 % quantile of Student's distribution, m - n degrees
//
// J the derivative of m values by n parameters at the optimum. Where the uncertainties of the data
// are known s = 1, and t is that of the normal distribution. What holds for the interval of a
// linear model with normal noise holds near enough where the model is linear over the interval.
//   G. A. F. Seber, C. J. Wild, Nonlinear Regression, Wiley 1989, chapter 2.
#pragma once

#include "graze/fit/fit_result.hpp"

namespace graze {

// Throws InputError for parameters that cannot be sought, and for measurements that are too few for
// them or far from all that the scene says (with file:line:column).
FitResult fit(const Scene& scene, const Measurements& measurements, const FitOptions& options);

}  // namespace graze
