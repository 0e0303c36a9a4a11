#include "graze/bifurcation/cut/detail/release_approach.hpp"

#include <limits>

namespace graze {
namespace {

constexpr int kMostSteps = 400;  // of a bisection that may need two for each of some 100 halvings

}  // namespace

ReleaseApproach approach_boundary(const SegmentEquations& equations, Corrector& corrector,
                                  const StopSignal& stop, const SolutionPoint& a,
                                  const SolutionPoint& b, const ReleaseReturn& at_a, bool impacts) {
  const Vector chord = corrector.chord(a, b);
  ReleaseApproach result;
  SolutionPoint inside = a;
  if (inside.tangent.dot(chord) < 0.0) inside.tangent *= -1.0;
  result.reached = {inside};
  result.last = at_a;
  result.beyond = equations.follow(b);
  result.at_beyond = b;
  // Two points nearer than this are the same in double precision.
  const double least =
      4.0 * std::numeric_limits<double>::epsilon() * (1.0 + corrector.pack(a).norm());
  if (result.beyond && result.beyond->returns)
    result.others.emplace_back(b, result.beyond->sticking);
  // Some two steps for each bit; more of them would lead past `b`.
  double h = 0.5 * chord.norm();
  for (int step = 0; h > least && step < kMostSteps && !stop.requested(); ++step) {
    std::optional<SolutionPoint> next =
        corrector.on_hyperplane(corrector.pack(inside) + h * inside.tangent, inside.tangent);
    const std::optional<ReleaseReturn> back =
        next ? equations.follow(*next) : std::optional<ReleaseReturn>();
    if (back && has_same_events(*back, at_a, impacts)) {
      inside = *next;
      result.last = *back;
      result.reached.push_back(inside);
      continue;
    }
    if (back) {
      result.beyond = back;
      result.at_beyond = *next;
      if (back->returns) result.others.emplace_back(*next, back->sticking);
    }
    h *= 0.5;
  }
  result.settled = h <= least;
  return result;
}

}  // namespace graze
