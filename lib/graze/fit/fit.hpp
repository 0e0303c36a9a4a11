// Parameters of a scene from measurements: the values with the least sum of squares of the
// differences between measurements and scene, each in units of its uncertainty, and how well the
// data determine them.
//
//   covariance   s^2 (J^T J)^-1,   s^2 = sum of squares/(m - n)
//   interval     value -+ t s_j,   t the 97.5 % quantile of Student's distribution, m - n degrees
//
// J is the derivative of m values by n parameters at the optimum. Where the uncertainties of the
// data are known s = 1, and t is that of the normal distribution. The intervals are those of a
// linear model with normal noise, a good approximation where the model is nearly linear over the
// interval.
//   G. A. F. Seber, C. J. Wild, Nonlinear Regression, Wiley 1989, chapter 2.
#pragma once

#include "graze/fit/fit_result.hpp"

namespace graze {

// Throws InputError for parameters that cannot be fitted, and for measurements that are too few for
// them or far from the values of the scene (with file:line:column).
FitResult fit(const Scene& scene, const Measurements& measurements, const FitOptions& options);

}  // namespace graze
