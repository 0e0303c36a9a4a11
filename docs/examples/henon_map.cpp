// x -> 1 - p x^2 + y, y -> 0.3 x: fold at p = -0.1225, period doubling at 0.3675.
#include <cstdio>

#include "graze/continuation/map.hpp"

using namespace graze;

int main() {
  const Map henon{[](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
    const double p = parameters[0];
    MapEvaluation at{Vector(2), Matrix(2, 2), Vector(2)};
    at.image << 1.0 - p * x[0] * x[0] + x[1], 0.3 * x[0];
    at.jacobian << -2.0 * p * x[0], 1.0, 0.3, 0.0;
    at.by_parameters << -x[0] * x[0], 0.0;
    return at;
  }};
  const ContinuationOptions options{.from = -1.0, .to = 1.0};
  const ZeroProblem problem = periodic_points(henon);
  const auto start = solve_at(problem, options, Vector::Constant(2, 1.0), 0.1);
  if (!start) return 3;
  for (const CriticalPoint& special : trace_branch(problem, options, *start).critical)
    std::printf("%s p = %.12f multiplier %.9f\n", label_of(special.kind), special.point.parameter,
                special.multiplier->value.real());
}
