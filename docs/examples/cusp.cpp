// p = u^3 - 3 u, the cusp x^3 - a x - p unfolded at a = 3: folds at u = -1, p = 2 and u = 1, p =
// -2.
#include <cstdio>

#include "graze/continuation/branch.hpp"

using namespace graze;

int main() {
  ZeroProblem cusp;
  cusp.evaluate = [](const Vector& u, Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double p = parameters[0];
    const double square = u[0] * u[0];
    return ZeroEvaluation{Vector::Constant(1, u[0] * (square - 3.0) - p),
                          Matrix::Constant(1, 1, 3.0 * (square - 1.0)), Vector::Constant(1, -1.0)};
  };
  ContinuationOptions options;
  options.from = -5.0;
  options.to = 5.0;
  const auto start = solve_at(cusp, options, Vector::Constant(1, 2.5), 4.0);
  if (!start) return 3;
  for (const CriticalPoint& special : trace_branch(cusp, options, *start).critical)
    std::printf("%s p = %.12f\n", label_of(special.kind), special.point.parameter);
}
