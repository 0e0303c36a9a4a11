#include "graze/bifurcation/cut/detail/release_grazing.hpp"

#include <cmath>

#include "graze/bifurcation/cut/detail/grazing_search.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"

namespace graze {
namespace {

// An approach nearer than this part of a length touches: a trace that comes to its end there is
// within its shortest step, some 1e-12, of the grazing.
constexpr double kGrazes = 1e-9;
// An impact this slow, in units of speed, at a bisected point is one that vanishes there.
constexpr double kStill = 1e-5;
// When an impact is this slow, in units of speed, the trace ends: its square is a thousand times
// the residual tolerance.
constexpr double kSlowAtRelease = 1e-4;
// Distance on the other side at which an orbit without the impact is searched for, of the range.
constexpr double kBesideRelease = 1e-5;

double length_unit(const SegmentEquations& equations, const SolutionPoint& at) {
  return motion_scale(*equations.system_at(at.parameter)).length;
}

double speed_unit(const SegmentEquations& equations, const SolutionPoint& at) {
  return length_unit(equations, at) * equations.system_at(at.parameter)->forcing()->frequency;
}

// The orbit without the vanishing impact: it may lie on either side.
std::optional<SolutionPoint> without_impact(const SegmentEquations& equations,
                                            const ContinuationOptions& options,
                                            const SolutionPoint& at, double grazing) {
  const std::optional<ReleaseReturn> here = equations.follow(at);
  if (!here) return {};
  const double beside = kBesideRelease * std::abs(options.to - options.from);
  for (const double side : {1.0, -1.0}) {
    std::optional<SolutionPoint> other =
        solve_at(equations.problem(), options, at.u, grazing + side * beside);
    if (!other) continue;
    const std::optional<ReleaseReturn> there = equations.follow(*other);
    if (there && there->returns && there->sticking == here->sticking &&
        there->itinerary.events.size() < here->itinerary.events.size())
      return other;
  }
  return {};
}

}  // namespace

bool touches(const SegmentEquations& equations, const SolutionPoint& at) {
  const std::optional<ReleaseReturn> here = equations.follow(at, true);
  return here && here->segment.clearance() &&
         *here->segment.clearance() <= kGrazes * length_unit(equations, at);
}

ReleaseTip grazing_at(const SegmentEquations& equations, const ContinuationOptions& options,
                      const SolutionPoint& at, bool is_lost) {
  const std::optional<ReleaseReturn> here = equations.follow(at);
  if (!here) return {};
  const double unit = speed_unit(equations, at);
  const bool by_speed = is_lost || here->itinerary.slowest <= kStill * unit;
  if (!by_speed && !touches(equations, at)) return {};
  ReleaseTip tip{OrbitBranchEnd::kGrazing, at, by_speed, false, at.parameter, {}};
  // The nearest solution stands for the grazing contact when that cannot be found.
  const auto grazing = find_grazing_from(equations, options, at);
  if (grazing) tip.value = grazing->at.parameter;
  tip.bracket = bracket_around({at.parameter, tip.value}, grazing.has_value());
  return tip;
}

ReleaseTip grazing_ahead(const SegmentEquations& equations, const ContinuationOptions& options,
                         const SolutionPoint& a, const SolutionPoint& b) {
  const std::optional<ReleaseReturn> before = equations.follow(a), now = equations.follow(b);
  if (!before || !now || !now->returns || now->sticking != before->sticking) return {};
  const double unit = speed_unit(equations, b);
  if (!(now->itinerary.slowest <= kSlowAtRelease * unit &&
        now->itinerary.slowest < before->itinerary.slowest))
    return {};
  const std::optional<FoundGrazing> grazing = find_grazing_from(equations, options, b);
  if (!grazing) return {};
  ReleaseTip tip{OrbitBranchEnd::kGrazing, b, true, false, grazing->at.parameter, {}};
  tip.beyond = without_impact(equations, options, b, tip.value);
  tip.bracket = bracket_around({b.parameter, tip.value}, true);
  return tip;
}

}  // namespace graze
