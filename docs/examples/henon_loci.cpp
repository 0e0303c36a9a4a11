// x -> 1 - p x^2 + y, y -> q x over both parameters: the folds p = -(1 - q)^2/4 with a resonance
// 1:1 at p = -1, the period doublings p = 3 (1 - q)^2/4 with one of 1:2 at p = 3.
#include <cstdio>

#include "graze/continuation/locus/locus.hpp"
#include "graze/continuation/map.hpp"

using namespace graze;

int main() {
  Map henon;
  henon.evaluate = [](const Vector& x, Parameters parameters) {
    const double p = parameters[0], q = parameters[1];
    return std::optional(MapEvaluation{Vector{{1.0 - p * x[0] * x[0] + x[1], q * x[0]}},
                                       Matrix{{-2.0 * p * x[0], 1.0}, {q, 0.0}},
                                       Matrix{{-x[0] * x[0], 0.0}, {0.0, x[0]}}});
  };
  // Of w^T df/dx v = w_1 (v_2 - 2 p x_1 v_1) + w_2 q v_1 by x_1, x_2, p, q.
  henon.curvature = [](const Vector& x, Parameters parameters, const Vector& w, const Vector& v) {
    const double p = parameters[0];
    const double product = w[0] * v[0];
    return std::optional(Vector{{-2.0 * p * product, 0.0, -2.0 * x[0] * product, w[1] * v[0]}});
  };
  const LocusOptions options{
      .first_from = -3.0, .first_to = 4.0, .second_from = -1.2, .second_to = 0.5};
  const LocusStart fold{LocusKind::kFold, Vector{{2.1, 0.1}}, -0.2, 0.0};
  const LocusStart doubling{LocusKind::kPeriodDoubling, Vector{{0.6, 0.1}}, 0.7, 0.0};
  for (const LocusStart& start : {fold, doubling})
    if (const auto locus = trace_locus(periodic_points(henon), options, start))
      for (const LocusSpecialPoint& special : locus->special)
        std::printf("%s of %s: p = %.10f, q = %.10f\n", label_of(special.kind),
                    label_of(locus->kind), special.point.first, special.point.second);
}
