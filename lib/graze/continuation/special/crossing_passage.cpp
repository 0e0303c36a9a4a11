#include "graze/continuation/special/detail/crossing_passage.hpp"

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {

std::optional<SolutionPoint> CrossingPassage::pass(GrowingBranch& branch, double& h) {
  const Vector x = corrector_.pack(branch.last());
  std::optional<SolutionPoint> next;
  for (const double part : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    h = part * kShortest * (1.0 + x.norm());
    // Where that reach did not lead clear of the branch point a longer one may: how far points are
    // badly determined goes with the accuracy of the equations.
    if (stuck_ && (*stuck_ - x).norm() <= h && h <= reach_) continue;
    next = pass_within(branch, h);
    if (next) break;
  }
  stuck_ = x;
  reach_ = h;
  return next;
}

// Goes back half of `reach`, drops the points in between, and takes a step of nearly all of it.
std::optional<SolutionPoint> CrossingPassage::pass_within(GrowingBranch& branch, double reach) {
  const Vector x = corrector_.pack(branch.last());
  const auto distance = [&](const SolutionPoint& p) { return (corrector_.pack(p) - x).norm(); };
  std::size_t keep = branch.size();
  while (keep > 0 && distance(branch[keep - 1]) < 0.5 * reach) --keep;
  if (keep < 2) return {};
  SolutionPoint base = branch[keep - 1];
  const SolutionPoint* before = &branch[keep - 2];
  const double back = (x - corrector_.pack(base)).dot(base.tangent) - 0.5 * reach;
  if (back > 0.0) {
    const std::optional<SolutionPoint> nearer =
        corrector_.on_hyperplane(stepper_.prediction(before, base, back), base.tangent);
    if (!nearer || nearer->orientation != base.orientation) return {};
    before = &branch[keep - 1];
    base = *nearer;
  }
  double turn = 0.0;
  std::optional<SolutionPoint> next = stepper_.step(before, base, 0.9 * reach, turn, reach);
  if (!next) return {};
  branch.keep(keep);
  if (back > 0.0) branch.add(base);
  return next;
}

}  // namespace graze
