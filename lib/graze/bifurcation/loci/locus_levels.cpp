// The starts of loci of levels, in the equations of whatever layout their orbits have.
#include <array>

#include "graze/bifurcation/loci/detail/level_curve.hpp"
#include "graze/bifurcation/loci/detail/locus_tracer.hpp"
#include "graze/bifurcation/problem/detail/response_equations.hpp"

namespace graze {

LocusTracer::CurveStart LocusTracer::level(const OrbitLocusStart& start) {
  const std::array<double, 2> place = start.place();
  if (start.meets_stops()) {
    const std::vector<Written> list = written(start);
    return list.empty() ? CurveStart()
                        : level_from(start, problems_.clear_of_contacts(list.front(), place));
  }
  LaidOrbits& orbits = problems_.response();
  const auto& equations = dynamic_cast<const ResponseEquations&>(*orbits.problem);
  const std::optional<Vector> u = equations.unknowns_at(place);
  return u ? level_from(start, {&orbits, *u}) : CurveStart();
}

LocusTracer::CurveStart LocusTracer::level_from(const OrbitLocusStart& start, const Written& one) {
  const OrbitProblem& problem = *one.orbits->problem;
  Curves& curves = curves_[{&problem, -2 - static_cast<int>(start.level)}];
  const double unit = first_range(options_);
  if (!curves.curve)
    curves.curve = std::make_unique<LevelCurve>(problem, one.u.size(), orbits_.levels[start.level],
                                                std::array{unit, second_range(options_)});
  Vector y(one.u.size() + 1);
  y << one.u, start.first / unit;
  return {&curves, y};
}

// Its unknown in every form in which its curve may be known.
std::vector<LocusTracer::CurveStart> LocusTracer::forms_of(const OrbitLocusStart& start) {
  if (!is_of_level(start.kind) || !start.meets_stops()) return {curve_at(start)};
  std::vector<CurveStart> forms;
  for (const Written& here : written(start))
    for (const Written& one : problems_.on_every_section(here, start.place()))
      forms.push_back(level_from(start, one));
  return forms;
}

}  // namespace graze
