// Derivatives by central differences, for comparison with analytic ones.
#pragma once

#include <functional>

#include "graze/base/vector.hpp"

namespace graze::support {

// Fourth order: error h^4 f^(5)/30 and eps |f|/h.
inline Vector central_difference(const std::function<Vector(double)>& f, double x, double h) {
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

// Column i: derivative by x_i, with steps h_i.
inline Matrix central_jacobian(const std::function<Vector(const Vector&)>& f, const Vector& x,
                               const Vector& h) {
  Matrix jacobian(f(x).size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto along = [&](double xi) {
      Vector moved = x;
      moved[i] = xi;
      return f(moved);
    };
    jacobian.col(i) = central_difference(along, x[i], h[i]);
  }
  return jacobian;
}

}  // namespace graze::support
