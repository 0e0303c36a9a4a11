#include "graze/bifurcation/problem/orbit_branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace graze {
namespace {

SpecialKind as_special_kind(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::kFold:
      return SpecialKind::kFold;
    case CriticalKind::kPeriodDoubling:
      return SpecialKind::kPeriodDoubling;
    case CriticalKind::kTorus:
      return SpecialKind::kTorus;
    case CriticalKind::kLevel:
      return SpecialKind::kLevel;
    case CriticalKind::kExtreme:
      return SpecialKind::kExtreme;
    case CriticalKind::kBranchPoint:
      break;
  }
  return SpecialKind::kBranchPoint;
}

}  // namespace

std::optional<SpecialPoint::Impact> SpecialPoint::impact() const {
  if (kind == SpecialKind::kLiftOff) return Impact{wrapped(solution.u[0]), 0.0};
  if (at.orbit.impacts.empty()) return {};
  return Impact{at.orbit.impacts.front().phase, at.orbit.impacts.front().speed};
}

OrbitBranchPoint point_of_branch(double value, Orbit orbit) {
  OrbitBranchPoint point;
  point.value = value;
  point.unstable_multipliers = count_multipliers(orbit.multipliers).outside;
  point.smallest_speed = std::numeric_limits<double>::infinity();
  for (const OrbitImpact& impact : orbit.impacts)
    point.smallest_speed = std::min(point.smallest_speed, impact.speed);
  point.orbit = std::move(orbit);
  return point;
}

bool is_of_orbits(const CriticalPoint& critical) {
  // A branch point is interpolated over a step of 1e-6; its multiplier is 1 within the square root
  // of that.
  constexpr double kAtOne = 1e-3;
  return critical.kind != CriticalKind::kBranchPoint ||
         (critical.multiplier && std::abs(critical.multiplier->value - 1.0) <= kAtOne);
}

OrbitBranchPoint with_critical(OrbitBranchPoint at, const CriticalPoint& critical) {
  if (is_of_level(critical.kind)) return at;
  const bool is_pair = critical.kind == CriticalKind::kTorus;
  Complex where = critical.kind == CriticalKind::kPeriodDoubling ? -1.0 : 1.0;
  if (is_pair && critical.multiplier) where = critical.multiplier->value;
  std::vector<Eigenvalue> multipliers = at.orbit.multipliers;
  for (const Complex at_circle : {where, std::conj(where)}) {
    const auto nearest = nearest_to(multipliers, at_circle);
    if (nearest == multipliers.end()) return at;
    nearest->error = std::max(nearest->error, std::abs(std::abs(nearest->value) - 1.0));
    if (!is_pair) break;
  }
  at.unstable_multipliers = count_multipliers(multipliers).outside;
  at.orbit.stable = stability(multipliers);
  return at;
}

SpecialPoint as_special(const CriticalPoint& critical, OrbitBranchPoint at) {
  SpecialPoint special{
      as_special_kind(critical.kind), "", std::move(at), {}, false, critical.point};
  if (critical.multiplier) special.multiplier = critical.multiplier->known();
  special.level = critical.level;
  return special;
}

OrbitBranchEnd as_orbit_end(BranchEnd end) {
  switch (end) {
    case BranchEnd::kParameterLimit:
      return OrbitBranchEnd::kParameterLimit;
    case BranchEnd::kClosed:
      return OrbitBranchEnd::kClosed;
    case BranchEnd::kStart:  // only branches from a doubling are traced one way
      return OrbitBranchEnd::kPeriodDoubling;
    case BranchEnd::kStepLimit:
      return OrbitBranchEnd::kStepLimit;
    case BranchEnd::kOutOfTime:
      return OrbitBranchEnd::kOutOfTime;
    case BranchEnd::kStopped:
      return OrbitBranchEnd::kStopped;
    case BranchEnd::kUnknownLimit:
    case BranchEnd::kHalted:
    case BranchEnd::kNotConverged:
      break;
  }
  return OrbitBranchEnd::kNotConverged;
}

}  // namespace graze
