#include "graze/bifurcation/cut/detail/release_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "graze/bifurcation/cut/detail/release_completion.hpp"
#include "graze/bifurcation/cut/detail/release_grazing.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"
#include "graze/continuation/branch/detail/locate.hpp"
#include "graze/continuation/special/detail/critical.hpp"
#include "graze/orbit/problem/detail/chatter_completion.hpp"
#include "graze/orbit/problem/detail/segment_events.hpp"

namespace graze {
namespace {

// Beyond a CH there is no single branch. The structure leaves its stop before it has come to rest,
// after as many impacts as fit in; the number grows by one in each of infinitely many windows that
// accumulate at CH, narrower from one to the next by a factor that depends on the restitution (1.25
// at r = 0.8, 2.0 at 0.5). The orbits of the first windows are searched for.

constexpr int kWindows = 6;
// Values examined in each window: a solution there may belong to the next one.
constexpr int kLooks = 2;
// Distance from CH of the first search, relative to the range.
constexpr double kFirst = 0.02;

// A motion from the release that does not come back to rest, as impacts and flights.
std::optional<Orbit> impacts_of(const System& system, const SegmentEquations& equations,
                                const SolutionPoint& solution) {
  std::optional<ReleaseReturn> back = equations.follow(solution);
  if (!back || back->returns || !back->sticking.empty()) return {};
  Orbit orbit;
  orbit.period = equations.period();
  orbit.section.emplace().states = {back->segment.end};
  back->segment.sticking.clear();
  add_events(system, {back->segment}, orbit.period, {}, orbit);
  orbit.section.reset();
  return orbit.impacts.empty() ? std::nullopt : std::optional(std::move(orbit));
}

// Starts for these orbits: the impacts of solutions of the equations at the release, which go on
// beyond CH as motions that come near the stop instead of to rest on it; from `outer`, beyond the
// CH at `boundary`, towards that. Each with the value of the parameter, farthest first; none where
// another stop holds the structure.
std::vector<OrbitBranchPoint> windows_beyond(const SegmentEquations& equations,
                                             const ContinuationOptions& options,
                                             const SolutionPoint& boundary,
                                             const SolutionPoint& outer) {
  std::vector<OrbitBranchPoint> list;
  const auto released = static_cast<std::size_t>(*equations.layout().released);
  const Stop& stop = equations.system_at(boundary.parameter)->stops[released];
  // The factor by which a window is narrower than the previous one. Without restitution the impact
  // that ends a flight is the only one.
  const double crowding = parting_ratio(stop.restitution().at_rest());
  if (!std::isfinite(crowding)) return list;
  const double closer = std::pow(crowding, 1.0 / kLooks);
  const double step = outer.parameter - boundary.parameter;
  double part = std::max(1.0, kFirst * std::abs((options.to - options.from) / step));
  for (int look = 0; look < kLooks * kWindows; ++look, part /= closer) {
    const double value = boundary.parameter + part * step;
    if (value < std::min(options.from, options.to) || value > std::max(options.from, options.to))
      continue;
    const Vector guess = boundary.u + part * (outer.u - boundary.u);
    const auto solution = solve_at(equations.problem(), options, guess, value);
    const System* system = solution ? equations.system_at(value) : nullptr;
    if (!system) continue;
    if (std::optional<Orbit> orbit = impacts_of(*system, equations, *solution))
      list.push_back(point_of_branch(value, std::move(*orbit)));
  }
  return list;
}

// Largest number of changes of the itinerary followed within one step. Beside CH the impacts of the
// chatter that no longer completes vanish one after the other, some thirty in double precision.
constexpr int kMostChanges = 64;

// Largest number of solutions examined between two with the same events.
constexpr int kMostLooks = 40;

// A point beyond may be only a prediction, which has no tangent and is not followed.
bool is_solved(const SolutionPoint& point) { return point.tangent.size() > 0; }

void drop_last(Branch& trace, std::size_t side) {
  trace.points.erase(side == 0 ? trace.points.begin() : trace.points.end() - 1);
  const std::size_t size = trace.points.size();
  std::erase_if(trace.critical, [&](const CriticalPoint& critical) {
    return side == 0 ? critical.after == 0 : critical.after + 1 >= size;
  });
  if (side == 1) return;
  for (CriticalPoint& critical : trace.critical) --critical.after;
}

}  // namespace

ReleaseBoundaries::ReleaseBoundaries(const SegmentEquations& equations,
                                     const ContinuationOptions& options, bool switches)
    : equations_(equations),
      options_(options),
      switches_(switches),
      corrector_(equations.problem(), options_),
      hidden_(equations, corrector_) {}

bool ReleaseBoundaries::goes_on(const SolutionPoint& previous, const SolutionPoint& here) {
  const auto before = equations_.follow(previous), now = equations_.follow(here);
  if (!before || !now || !now->returns || now->sticking != before->sticking) return false;
  // Where the equations contain the impacts, between() decides.
  return !equations_.see_impacts() || !between(previous, here).boundary;
}

ReleaseTip ReleaseBoundaries::between(const SolutionPoint& a, const SolutionPoint& b) {
  ReleaseTip first;
  if (equations_.see_impacts()) first = grazing_ahead(equations_, options_, a, b);
  if (first.boundary) return first;
  walk(a, b, equations_.see_impacts(), [&](const ReleaseTip& tip) {
    first = tip;
    return true;
  });
  return first;
}

ReleaseTip ReleaseBoundaries::at_last(const SolutionPoint& at) {
  const std::optional<ReleaseReturn> here = equations_.follow(at);
  // The trace has come as near as the equations can be solved.
  if (here && has_shrunk(*here, equations_.period_at(at)))
    return {OrbitBranchEnd::kChatterCompletes,    at, false, false, at.parameter, {},
            bracket_around({at.parameter}, false)};
  return grazing_at(equations_, options_, at, false);
}

void ReleaseBoundaries::pass(const JudgedPoint& a, const JudgedPoint& b,
                             std::vector<BranchPlace>& places) {
  if (equations_.see_impacts()) return;
  walk(a.point, b.point, true, [&](const ReleaseTip& tip) {
    if (tip.end != OrbitBranchEnd::kGrazing) return false;
    // The branch goes on to the orbit beyond.
    ReleaseTip passed = tip;
    passed.beyond.reset();
    if (std::optional<BranchPlace> place = place_of(passed)) places.push_back(std::move(*place));
    return false;
  });
}

std::optional<BranchPlace> ReleaseBoundaries::place_of(const ReleaseTip& tip) const {
  if (!tip.boundary) return {};
  std::optional<OrbitBranchPoint> at = equations_.judge(*tip.boundary);
  if (!at) return {};
  BranchPlace place{std::move(*at), {}, true, tip.end};
  place.at.value = tip.value;
  SolutionPoint solution = *tip.boundary;
  solution.bracket = tip.bracket;
  SpecialKind kind = SpecialKind::kChatterCompletes;
  if (tip.end == OrbitBranchEnd::kGrazing) kind = SpecialKind::kGrazing;
  if (tip.end == OrbitBranchEnd::kAtRest) {
    kind = SpecialKind::kLiftOff;
    const double range = std::abs(options_.to - options_.from);
    if (const auto there = lift_off(equations_, range, tip)) {
      place.at.value = solution.parameter = there->first;
      solution.u[0] = there->second;
      solution.bracket = bracket_around({tip.bracket.from, tip.bracket.to, there->first}, true);
    }
  }
  place.special = SpecialPoint{kind, "", place.at, {}, tip.by_speed, solution, tip.interrupted};
  if (switches_ && tip.beyond)
    if (const auto other = equations_.judge(*tip.beyond)) place.others = {*other};
  return place;
}

// Where the trace was halted its last point lies beyond the boundary.
std::optional<BranchTip> ReleaseBoundaries::close(Branch& trace, std::size_t side) {
  std::vector<SolutionPoint>& points = trace.points;
  const bool halted = trace.ends[side] == BranchEnd::kHalted;
  if (!halted && trace.ends[side] != BranchEnd::kNotConverged) return {};
  ReleaseTip tip;
  if (!halted) {
    tip = at_last(side == 0 ? points.front() : points.back());
    return BranchTip{tip.end, place_of(tip)};
  }
  tip = side == 0 ? between(points[1], points[0]) : between(points.end()[-2], points.back());
  std::optional<BranchPlace> place = place_of(tip);
  if (!place) {
    drop_last(trace, side);
    return BranchTip{tip.end, {}};
  }
  if (switches_ && tip.end == OrbitBranchEnd::kChatterCompletes && place->others.empty())
    place->others = windows_beyond(equations_, options_, *tip.boundary,
                                   side == 0 ? points.front() : points.back());
  end_at(*tip.boundary, trace, side);
  return BranchTip{tip.end, std::move(place)};
}

// Keeps of the last step only the part up to the boundary, with the special points in it.
void ReleaseBoundaries::end_at(const SolutionPoint& boundary, Branch& trace, std::size_t side) {
  const std::size_t first = side == 0 ? 0 : trace.points.size() - 2;
  trace.points[side == 0 ? 0 : first + 1] = boundary;
  const ZeroProblem& problem = equations_.problem();
  Branch step;
  step.points = {trace.points[first], trace.points[first + 1]};
  const Vector chord = corrector_.chord(step.points[0], step.points[1]);
  for (SolutionPoint& point : step.points) {
    if (point.tangent.dot(chord) < 0.0) point.turn_round();
    point.multipliers = problem.multipliers(point.u, point.parameters(), ErrorBounds::kGiven);
  }
  if (const auto fold = fold_between(corrector_, step.points[0], step.points[1]))
    step.critical.push_back({CriticalKind::kFold, *fold, 0, {}});
  add_critical_points(step, problem, corrector_, options_.stop);
  // Where the boundary is a fold of the equations (a flight proportional to the root of the
  // distance) solutions beside it may lie beyond.
  const auto here = equations_.follow(trace.points[side == 0 ? 1 : first]);
  std::erase_if(step.critical, [&](const CriticalPoint& critical) {
    const std::optional<ReleaseReturn> there = equations_.follow(critical.point);
    return !here || !there || there->sticking != here->sticking;
  });
  std::erase_if(trace.critical,
                [&](const CriticalPoint& critical) { return critical.after == first; });
  for (CriticalPoint& critical : step.critical) critical.after = first;
  trace.critical.insert(side == 0 ? trace.critical.begin() : trace.critical.end(),
                        step.critical.begin(), step.critical.end());
}

// Walks from a to b along the changes of the events, and passes the end found at each to
// `is_enough` until that returns true. `impacts`: see has_same_events().
void ReleaseBoundaries::walk(const SolutionPoint& a, const SolutionPoint& b, bool impacts,
                             const std::function<bool(const ReleaseTip&)>& is_enough) {
  SolutionPoint from = a;
  std::optional<ReleaseReturn> here = equations_.follow(a);
  const std::optional<ReleaseReturn> at_b = equations_.follow(b);
  int looks = kMostLooks;
  for (int change = 0; here && change < kMostChanges && !options_.stop.requested(); ++change) {
    SolutionPoint target = b;
    // All changes up to `b` may end nothing.
    if (at_b && has_same_events(*at_b, *here, impacts)) {
      const std::optional<SolutionPoint> other = hidden_.between(from, b, *here, looks);
      if (!other) return;
      target = *other;
    }
    const ReleaseApproach there =
        approach_boundary(equations_, corrector_, options_.stop, from, target, *here, impacts);
    const bool solved = is_solved(there.at_beyond);
    const bool same_sticking = there.beyond && (there.beyond->returns || !solved) &&
                               there.beyond->sticking == here->sticking;
    if (!same_sticking) {
      is_enough(completion(equations_, there));
      return;
    }
    const ReleaseTip at_grazing = grazing(there, *here);
    if (at_grazing.boundary && is_enough(at_grazing)) return;
    if (!solved) return;
    // Nothing ends here; go on from the other side.
    from = there.at_beyond;
    here = there.beyond;
  }
}

// The grazing at the boundary that was approached from `here`, across which the stuck phases are
// the same.
ReleaseTip ReleaseBoundaries::grazing(const ReleaseApproach& there, const ReleaseReturn& here) {
  const bool solved = is_solved(there.at_beyond);
  // The impact of a grazing exists down to some speed; on the other side the same approach touches.
  const bool is_lost = solved &&
                       here.itinerary.events.size() > there.beyond->itinerary.events.size() &&
                       touches(equations_, there.at_beyond);
  ReleaseTip tip = grazing_at(equations_, options_, there.reached.back(), is_lost);
  if (tip.boundary && solved) {
    tip.beyond = there.at_beyond;
    tip.bracket = bracket_around({tip.bracket.from, tip.bracket.to, there.at_beyond.parameter},
                                 tip.bracket.converged);
  }
  return tip;
}

}  // namespace graze
