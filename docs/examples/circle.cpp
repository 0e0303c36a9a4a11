// u^2 + p^2 = 1: a branch that closes, with folds at p = -1 and p = 1.
#include <cstdio>

#include "graze/continuation/branch.hpp"

using namespace graze;

int main() {
  ZeroProblem circle;
  circle.evaluate = [](const Vector& u, Parameters parameters) -> std::optional<ZeroEvaluation> {
    const double p = parameters[0];
    const double residual = u[0] * u[0] + p * p - 1.0;
    return ZeroEvaluation{Vector::Constant(1, residual), Matrix::Constant(1, 1, 2.0 * u[0]),
                          Vector::Constant(1, 2.0 * p)};
  };
  ContinuationOptions options;
  options.from = -2.0;
  options.to = 2.0;
  const auto start = solve_at(circle, options, Vector::Constant(1, 0.9), 0.1);
  if (!start) return 3;
  const Branch branch = trace_branch(circle, options, *start);
  for (const CriticalPoint& special : branch.critical)
    std::printf("%s p = %.12f\n", label_of(special.kind), special.point.parameter);
}
