#include "graze/bifurcation/orbit_borders.hpp"

#include <algorithm>

namespace graze {
namespace {

// No stop is penetrated by more, of the length scale.
constexpr double kPenetration = 1e-12;

bool penetrates(const OrbitEquations& equations, const BranchPoint& at) {
  const double length = motion_scale(*equations.system_at(at.parameters())).length;
  return equations.admissibility_of(at).clearance().value_or(0.0) < -kPenetration * length;
}

// Where an interior approach touches.
std::optional<BranchPoint> touch(const OrbitEquations& equations,
                                 const ContinuationOptions& options, const BranchPoint& a,
                                 const BranchPoint& b) {
  // Without an interior minimum the motion is as clear as its gap is wide.
  const auto clearance = [&](const BranchPoint& p) {
    return equations.admissibility_of(p).clearance();
  };
  const double clear = std::max(clearance(a).value_or(0.0), clearance(b).value_or(0.0)) + 1.0;
  return locate(equations.problem(), options, a, b,
                [&](const BranchPoint& p) { return clearance(p).value_or(clear); });
}

// Where an impact speed vanishes.
std::optional<BranchPoint> standstill(const OrbitEquations& equations,
                                      const ContinuationOptions& options, const SeenSolution& a,
                                      const SeenSolution& b) {
  // One of them is on the grazing within rounding.
  const double at_a = a.smallest_speed(), at_b = b.smallest_speed();
  if (at_a > 0.0 && at_b > 0.0) return at_a < at_b ? *a.point : *b.point;
  return locate(equations.problem(), options, *a.point, *b.point,
                [&](const BranchPoint& p) { return equations.admissibility_of(p).smallest_speed; });
}

// Where an impact that leaves its stop at rest is pushed back.
std::optional<BranchPoint> pushed_back(const OrbitEquations& equations,
                                       const ContinuationOptions& options, const BranchPoint& a,
                                       const BranchPoint& b) {
  const auto pull = [&](const BranchPoint& p) {
    return -equations.admissibility_of(p).push.value_or(-1.0);
  };
  if ((pull(a) < 0.0) == (pull(b) < 0.0)) return {};
  return locate(equations.problem(), options, a, b, pull);
}

std::optional<SpecialPoint> grazing(const OrbitEquations& equations,
                                    const ContinuationOptions& options, const SeenSolution& a,
                                    const SeenSolution& b) {
  const double still = still_speed(*equations.system_at(a.point->parameters()));
  bool by_speed = (a.smallest_speed() > still) != (b.smallest_speed() > still);
  std::optional<BranchPoint> point = by_speed ? standstill(equations, options, a, b)
                                              : pushed_back(equations, options, *a.point, *b.point);
  bool by_push = point && !by_speed;
  if (by_speed && !point) return {};
  // An approach may have touched before.
  const bool at_end = by_speed && a.smallest_speed() > 0.0 && b.smallest_speed() > 0.0;
  if (!point || (!at_end && penetrates(equations, *point))) {
    const bool before = point && a.admissible, behind = point && !before;
    by_speed = by_push = false;
    point = touch(equations, options, behind ? *point : *a.point, before ? *point : *b.point);
  }
  if (!point) return {};
  SpecialPoint special{SpecialKind::kGrazing, "", equations.judge(*point), {}, by_speed, *point};
  special.by_push = by_push;
  // It touches and does not cross; which side of that the last bit falls on says nothing.
  special.at.orbit.admissible = true;
  return special;
}

}  // namespace

std::optional<OrbitBorder> border_between(const OrbitEquations& equations,
                                          const ContinuationOptions& options, const SeenSolution& a,
                                          const SeenSolution& b) {
  const auto flight = [&](const BranchPoint& p) {
    return equations.admissibility_of(p).shortest_flight;
  };
  if ((flight(*a.point) > 0.0) != (flight(*b.point) > 0.0))
    if (const auto point = locate(equations.problem(), options, *a.point, *b.point, flight))
      return OrbitBorder{equations.judge(*point), {}};
  const std::optional<SpecialPoint> special = grazing(equations, options, a, b);
  if (!special) return {};
  return OrbitBorder{special->at, special};
}

}  // namespace graze
