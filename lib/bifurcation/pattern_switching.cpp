#include "graze/bifurcation/pattern_switching.hpp"

#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/touching_orbit.hpp"

namespace graze {
namespace {

PatternSwitch doubled(const OrbitEquations& equations, const SpecialPoint& special) {
  PatternSwitch next{equations.pattern(), equations.points(special.solution), {}};
  const double turn = kTurn * next.pattern.period;
  next.pattern.period *= 2;
  for (std::size_t i = 0, k = next.impacts.size(); i < k; ++i) {
    next.pattern.stops.push_back(next.pattern.stops[i]);
    next.impacts.push_back(next.impacts[i]);
    next.impacts.back().theta += turn;
  }
  const Vector& tangent = special.solution.tangent;
  const Eigen::Index n = tangent.size() - 1;
  next.known_tangent.resize(2 * n + 1);
  next.known_tangent << tangent.head(n), tangent.head(n), tangent[n];
  next.known_tangent.normalize();
  return next;
}

std::optional<PatternSwitch> with_touching_impact(const OrbitEquations& equations,
                                                  const SpecialPoint& special) {
  std::optional<TouchingOrbit> orbit =
      with_touch(*equations.system_at(special.solution.parameters()), equations.pattern(),
                 equations.points(special.solution));
  if (!orbit) return {};
  return PatternSwitch{std::move(orbit->pattern), std::move(orbit->impacts), {}};
}

std::optional<PatternSwitch> without_slowest(const OrbitEquations& equations,
                                             const SpecialPoint& special) {
  PatternSwitch next{equations.pattern(), equations.points(special.solution), {}};
  if (next.pattern.impacts() == 1) return {};
  const auto at = static_cast<std::ptrdiff_t>(equations.admissibility_of(special.solution).slowest);
  next.impacts.erase(next.impacts.begin() + at);
  next.pattern.stops.erase(next.pattern.stops.begin() + at);
  return next;
}

}  // namespace

std::optional<PatternSwitch> pattern_switch(const OrbitEquations& equations,
                                            const SpecialPoint& special) {
  switch (special.kind) {
    case SpecialKind::kPeriodDoubling:
      return doubled(equations, special);
    case SpecialKind::kBranchPoint:
      return PatternSwitch{equations.pattern(), equations.points(special.solution),
                           special.solution.tangent};
    case SpecialKind::kGrazing:
      // Beyond a push the orbits stick.
      if (special.by_push) break;
      return special.by_speed ? without_slowest(equations, special)
                              : with_touching_impact(equations, special);
    case SpecialKind::kFold:
    case SpecialKind::kTorus:
    case SpecialKind::kChatterCompletes:
    case SpecialKind::kLiftOff:
      break;
  }
  return {};
}

}  // namespace graze
