// The derivative of a model that is only known by its values, by differences. A step changes the
// sum of squares by about as much as the noise of the data does, s^2 (a parameter's own standard
// uncertainty, the others held), so that features finer than the noise do not matter. Without noise
// the change is eps^(1/3) of the size of the data, where rounding, eps/eps^(1/3), and curvature,
// eps^(2/3), cause equal errors (W. H. Press et al., Numerical Recipes, section 5.7).
//
// Each derivative is computed twice, with a step and half of it, and extrapolated; the difference
// of the two is its error. Where they disagree the step is made smaller.
#pragma once

#include <functional>
#include <optional>

#include "graze/base/vector.hpp"

namespace graze {

// Residuals of a model, (predicted - measured)/uncertainty; nullopt when they cannot be computed.
using Residuals = std::function<std::optional<Vector>(const Vector& parameters)>;

struct DifferenceJacobian {
  Matrix matrix;       // m x n
  Vector steps;        // in which it was taken, in units of the parameters
  double error = 0.0;  // largest of a column, relative to its length
};

// The derivative at `at`, within the limits (which may be infinite). `steps`: initial steps.
// `change` of the residuals' norm that a step is to make. Returns nullopt when the model cannot be
// evaluated around there.
std::optional<DifferenceJacobian> difference_jacobian(const Residuals& residuals, const Vector& at,
                                                      const Vector& low, const Vector& high,
                                                      const Vector& steps, double change);

}  // namespace graze
