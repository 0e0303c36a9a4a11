// x -> p x (1 - x): period doublings at p = 3 and, of the doubled orbits, 1 + sqrt(6).
#include <cstdio>

#include "graze/continuation/map.hpp"
#include "graze/continuation/switching.hpp"

using namespace graze;

int main() {
  const Map logistic{[](const Vector& x, Parameters parameters) -> std::optional<MapEvaluation> {
    const double p = parameters[0];
    const double growth = x[0] * (1.0 - x[0]);
    return MapEvaluation{Vector::Constant(1, p * growth),
                         Matrix::Constant(1, 1, p * (1.0 - 2.0 * x[0])),
                         Vector::Constant(1, growth)};
  }};
  const ContinuationOptions options{.from = 2.0, .to = 3.6};
  auto start = solve_at(periodic_points(logistic), options, Vector::Constant(1, 0.5), 2.0);
  for (int period = 1; start && period <= 4; period *= 2) {
    const Branch branch =
        trace_branch(periodic_points(logistic, period), options, *start, Directions::kForward);
    for (const CriticalPoint& special : branch.critical_of(CriticalKind::kPeriodDoubling)) {
      std::printf("period %d: PD p = %.12f\n", period, special.point.parameter);
      start =
          other_branch(periodic_points(logistic, 2 * period), options, twice_round(special.point));
    }
  }
}
