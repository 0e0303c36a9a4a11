#include "graze/bifurcation/sticking_switching.hpp"

#include <memory>

#include "graze/continuation/switching.hpp"

namespace graze {
namespace {

constexpr int kStepsAway = 3;

}  // namespace

std::optional<OrbitBranchPoint> orbit_beside(const PassageEquations& equations,
                                             const ContinuationOptions& options,
                                             const CriticalPoint& critical) {
  const bool doubles = critical.kind == CriticalKind::kPeriodDoubling;
  if (!doubles && critical.kind != CriticalKind::kBranchPoint) return {};
  const std::unique_ptr<PassageEquations> twice =
      doubles ? equations.doubled() : std::unique_ptr<PassageEquations>();
  const PassageEquations& next = doubles ? *twice : equations;
  BranchPoint at = doubles ? twice_round(next, critical.point) : critical.point;
  at.multipliers.clear();
  const std::optional<BranchPoint> start = other_branch(next.problem(), options, at);
  if (!start) return {};
  ContinuationOptions some = options;
  some.max_points = kStepsAway;
  some.proceed = {};
  ZeroProblem problem = next.problem();
  problem.multipliers = nullptr;
  return next.judge(trace_branch(problem, some, *start, Directions::kForward).points.back());
}

}  // namespace graze
