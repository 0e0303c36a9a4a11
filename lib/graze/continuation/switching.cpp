#include "graze/continuation/switching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {

std::optional<SolutionPoint> other_branch(const ZeroProblem& problem,
                                          const ContinuationOptions& options,
                                          const SolutionPoint& at) {
  Corrector corrector(problem, options);
  const Vector x = corrector.pack(at);
  const std::optional<Matrix> slope = corrector.slope_at(x);
  if (!slope) return {};
  const NullSpaces null = null_spaces(*slope, 2);
  Vector known = null.right * (null.right.transpose() * at.tangent);
  if (!(known.norm() > 0.0)) return {};
  known.normalize();
  // The direction of the null space at right angles to the known tangent.
  Vector across = null.right.col(0) - known.dot(null.right.col(0)) * known;
  const Vector second = null.right.col(1) - known.dot(null.right.col(1)) * known;
  if (second.norm() > across.norm()) across = second;
  across.normalize();
  // Second derivatives by differences: they only give a direction to search in, the corrector
  // decides. Their step balances the rounding of the slope against its third derivative.
  const double step = std::cbrt(std::numeric_limits<double>::epsilon()) * (1.0 + x.norm());
  const std::optional<Matrix> ahead = corrector.slope_at(x + step * across),
                              behind = corrector.slope_at(x - step * across);
  if (!ahead || !behind) return {};
  const Vector curving = (*ahead - *behind).transpose() * null.left.col(0) / (2.0 * step);
  const double mixed = curving.dot(known), pure = curving.dot(across);
  // 2 mixed a b + pure b^2 = 0 besides b = 0
  Vector tangent = 2.0 * mixed * across - pure * known;
  if (!(tangent.norm() > 0.0)) return {};
  tangent.normalize();
  SolutionPoint start = at;
  start.tangent = tangent;
  start.orientation = 0;
  return start;
}

void list_crossing(Branch& branch) {
  // The orientation has no sign change from it to the next point.
  const auto here =
      std::find_if(branch.points.begin(), branch.points.end(),
                   [&](const SolutionPoint& point) { return point.orientation == 0; });
  const bool at_ends = branch.closed() && here == branch.points.begin();
  if (!at_ends && (here == branch.points.begin() || here >= branch.points.end() - 1)) return;
  const auto index = static_cast<std::size_t>(here - branch.points.begin());
  CriticalPoint critical{CriticalKind::kBranchPoint, *here, at_ends ? 0 : index - 1, {}};
  critical.point.bracket = bracket_around({here->parameter}, true);
  if (!here->multipliers.empty()) critical.multiplier = *nearest_to(here->multipliers, 1.0);
  if (at_ends) {
    branch.critical.insert(branch.critical.begin(), std::move(critical));
    return;
  }
  branch.points.erase(here);
  for (CriticalPoint& other : branch.critical)
    if (other.after >= index) --other.after;
  const auto after = std::find_if(branch.critical.begin(), branch.critical.end(),
                                  [&](const CriticalPoint& other) { return other.after >= index; });
  branch.critical.insert(after, std::move(critical));
}

}  // namespace graze
