// Bending modes of a uniform beam clamped at xi = 0 and free at xi = 1 (unit length, unit mass).
//
//   cos(b) cosh(b) = -1,   shape(xi) = cosh(b xi) - cos(b xi) - s [sinh(b xi) - sin(b xi)],
//   s = (cosh b + cos b)/(sinh b + sin b),   integral of shape^2 = 1,   |shape(1)| = 2.
//
// The growing exponentials of the textbook shape cancel and lose every digit at j = 13; here they
// are combined by hand into decaying ones, so that the error stays about eps * b_j for every mode.
// Reference: R. D. Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1.
#pragma once

#include "graze/base/vector.hpp"

namespace graze {

// Wave number b_j of mode j = 1..kMostModes (dimensionless); the circular frequency is
// b_j^2 sqrt(EI/(rho A))/L^2.
double cantilever_wave_number(int j);

// Shape of mode j at xi in [0, 1], and its first and second derivative by xi; the error of the
// second is about eps b_j^3.
double cantilever_shape(int j, double xi);
double cantilever_slope(int j, double xi);
double cantilever_curvature(int j, double xi);

// Integral of the shape over [0, 1]: 2 s/b_j.
double cantilever_mean(int j);

}  // namespace graze
