#include "graze/continuation/branch/detail/growing_branch.hpp"

#include <cmath>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// A branch closes only after it has been this far from its start, well beyond kOnePoint.
constexpr double kAway = 1e-5;
// Tangents at a branch point that differ by less than this, rad, are the same: other branches cross
// at larger angles.
constexpr double kOneTangent = 1e-2;

}  // namespace

GrowingBranch::GrowingBranch(const ZeroProblem& problem, const ContinuationOptions& options,
                             Corrector& corrector, SolutionPoint start)
    : problem_(problem),
      options_(options),
      limits_(options),
      unknowns_(options),
      corrector_(corrector) {
  branch_.points.push_back(std::move(start));
}

bool GrowingBranch::advance(const SolutionPoint& next) {
  if (closes(next)) {
    add(closing_point());
    end(BranchEnd::kClosed);
    return true;
  }
  // A fold beyond the limit means that the branch left the range before it.
  const std::optional<SolutionPoint> fold = fold_between(corrector_, last(), next);
  const bool fold_outside = fold && limits_.outside(fold->parameter);
  const bool leaves = limits_.outside(next.parameter) || fold_outside;
  SolutionPoint reached = next;
  if (leaves) {
    const SolutionPoint& beyond = fold_outside ? *fold : next;
    const double limit = limits_.towards(beyond.parameter - last().parameter);
    const auto crossing = locate(corrector_, last(), beyond,
                                 [&](const SolutionPoint& p) { return p.parameter - limit; });
    if (!crossing) {
      end(BranchEnd::kNotConverged);
      return true;
    }
    reached = point_on_limit(corrector_, *crossing, limit).value_or(*crossing);
  }
  // Before that, an unknown may have left its range.
  if (const auto exit = unknowns_.exit_between(corrector_, last(), reached)) {
    end(exit->reached ? BranchEnd::kUnknownLimit : BranchEnd::kNotConverged);
    if (exit->reached) add(exit->point);
    return true;
  }
  add(reached);
  if (leaves) end(BranchEnd::kParameterLimit);
  return leaves;
}

void GrowingBranch::add(const SolutionPoint& next) {
  if (const auto fold = fold_between(corrector_, last(), next))
    branch_.critical.push_back({CriticalKind::kFold, *fold, size() - 1, {}});
  branch_.points.push_back(next);
  if (problem_.multipliers)
    branch_.points.back().multipliers =
        problem_.multipliers(next.u, next.parameters(), ErrorBounds::kGiven);
}

void GrowingBranch::keep(std::size_t count) {
  branch_.points.resize(count);
  std::erase_if(branch_.critical,
                [&](const CriticalPoint& critical) { return critical.after + 1 >= count; });
}

bool GrowingBranch::closes(const SolutionPoint& next) {
  const SolutionPoint& start = branch_.points.front();
  left_start_ = left_start_ || corrector_.chord(start, last()).norm() > kAway;
  if (start.orientation == 0) return left_start_ && crosses_start(next);
  return left_start_ && lies_between(corrector_, last(), next, start, options_.max_turn) &&
         start.tangent.dot(last().tangent) > 0.0;
}

// A start on a branch point is no regular solution to be corrected to. A branch comes back to it in
// a step so short that no other branch point lies there, and along the tangent that it left with: a
// branch that crosses itself passes the start before along another tangent. Tangents next to it are
// lost in rounding: the tangent of the last clear point is rotated on by the angle between it and
// the chord.
bool GrowingBranch::crosses_start(const SolutionPoint& next) {
  const SolutionPoint& start = branch_.points.front();
  if (last().orientation * next.orientation >= 0) return false;
  const double near = kOneCrossing * (1.0 + corrector_.pack(start).norm());
  if (corrector_.chord(last(), start).norm() > corrector_.chord(last(), next).norm() + near)
    return false;
  std::size_t clear = size() - 1;
  while (clear > 0 && corrector_.chord(branch_.points[clear], start).norm() <= near) --clear;
  if (clear == 0) return false;
  const Vector chord = corrector_.chord(branch_.points[clear], start).normalized();
  const Vector& before = branch_.points[clear].tangent;
  const Vector arriving = 2.0 * chord.dot(before) * chord - before;
  return start.tangent.dot(arriving) >= std::cos(kOneTangent);
}

// The start as the last point, with the angles that the branch has counted.
SolutionPoint GrowingBranch::closing_point() const {
  SolutionPoint start = branch_.points.front();
  start.u = (corrector_.pack(last()) + corrector_.chord(last(), start)).head(start.u.size());
  return start;
}

Branch joined(const Branch& backward, const Branch& forward) {
  Branch branch;
  branch.ends = {backward.ends[1], forward.ends[1]};
  branch.rejected = backward.rejected + forward.rejected;
  for (auto p = backward.points.rbegin(); p != backward.points.rend(); ++p) {
    branch.points.push_back(*p);
    branch.points.back().turn_round();
  }
  for (auto c = backward.critical.rbegin(); c != backward.critical.rend(); ++c) {
    branch.critical.push_back(*c);
    branch.critical.back().after = backward.points.size() - 2 - c->after;
    branch.critical.back().point.turn_round();
  }
  for (const CriticalPoint& c : forward.critical) {
    branch.critical.push_back(c);
    branch.critical.back().after += backward.points.size() - 1;
  }
  branch.points.insert(branch.points.end(), forward.points.begin() + 1, forward.points.end());
  return branch;
}

}  // namespace graze
