#include "graze/bifurcation/sticking_branches.hpp"

#include <algorithm>
#include <utility>

#include "graze/bifurcation/sticking_borders.hpp"
#include "graze/bifurcation/sticking_completion.hpp"

namespace graze {
namespace {

// Where the trace was halted it is one point too long: it ends at the special point there, if it
// was located.
void cut_beyond(Branch& trace, const OrbitBranch& judged) {
  const auto located = [&](std::size_t side) {
    return judged.ends[side] == OrbitBranchEnd::kChatterCompletes ||
           judged.ends[side] == OrbitBranchEnd::kAtRest ||
           judged.ends[side] == OrbitBranchEnd::kGrazing;
  };
  if (trace.ends[1] == BranchEnd::kHalted) {
    trace.points.pop_back();
    if (located(1)) trace.points.push_back(judged.special.back().solution);
  }
  if (trace.ends[0] == BranchEnd::kHalted) {
    if (located(0))
      trace.points.front() = judged.special.front().solution;
    else
      trace.points.erase(trace.points.begin());
  }
}

}  // namespace

bool StickingBranches::knows(const std::vector<LaidOrbit>& releases, double value) const {
  for (const Traced& traced : traced_)
    for (const LaidOrbit& at : releases) {
      if (!(at.layout == traced.equations->layout())) continue;
      const auto point = solve_at(traced.equations->problem(), range_,
                                  traced.equations->shooting().pack(at.theta, at.states), value);
      if (point && lies_on(traced.equations->problem(), range_, traced.branch, *point)) return true;
    }
  return false;
}

StickingTrace StickingBranches::trace(const Orbit& orbit, double value) {
  StickingTrace result;
  const std::optional<System> system = family_.at(value);
  if (!system || !orbit.sticks()) return result;
  const PassageOptions options{orbit.section->closure_speed, max_impacts_, range_.stop};
  const std::vector<LaidOrbit> releases = layouts_of(*system, orbit, options);
  if (releases.empty()) {
    result.why_not = "an orbit whose closed stops never let go is not continued";
    return result;
  }
  result.known = knows(releases, value);
  if (result.known) return result;
  const LaidOrbit& release = releases.front();
  const double range = std::max(std::abs(range_.to - range_.from), 0.0);
  Traced traced{std::make_unique<PassageEquations>(
                    family_.scene(), std::vector{family_.parameter()},
                    std::vector{range > 0.0 ? range : 1.0}, *system, release.layout, options),
                {}};
  const PassageEquations& equations = *traced.equations;
  const Vector u = equations.shooting().pack(release.theta, release.states);
  std::optional<BranchPoint> start = solve_at(equations.problem(), range_, u, value);
  // At a fold none is told by its value.
  if (!start) start = solve_near(equations.problem(), range_, u, value);
  const std::optional<ReleaseReturn> back =
      start ? equations.follow(*start) : std::optional<ReleaseReturn>();
  if (!back || !back->returns) {
    result.why_not = "the orbit that sticks was not found again at its release";
    return result;
  }
  if (has_shrunk(*back, equations.period_at(*start))) {
    result.why_not =
        "an orbit with stuck phases without end (a chatter on one stop throws the structure off "
        "another) is not continued";
    return result;
  }
  return trace_through(*start, std::move(traced));
}

StickingTrace StickingBranches::trace_through(const BranchPoint& start, Traced traced) {
  const PassageEquations& equations = *traced.equations;
  ContinuationOptions range = range_;
  StickingBorders borders(equations, range_);
  range.proceed = [&](const BranchPoint& previous, const BranchPoint& here) {
    return !equations.passes_half(previous, here) && !borders.passes(previous, here);
  };
  traced.branch = trace_branch(equations.problem(), range, start);
  std::optional<StickingVerdict> verdict =
      judge_sticking(equations, range, traced.branch, switches_);
  StickingTrace result;
  result.evaluations = traced.branch.evaluations;
  result.rejected = traced.branch.rejected;
  if (verdict) {
    const auto& ends = verdict->branch.ends;
    result.cut_short = std::any_of(ends.begin(), ends.end(), [](OrbitBranchEnd end) {
      return end == OrbitBranchEnd::kNotConverged || end == OrbitBranchEnd::kStepLimit;
    });
    cut_beyond(traced.branch, verdict->branch);
    result.branch = std::move(verdict->branch);
    result.neighbours = std::move(verdict->neighbours);
  } else {
    result.why_not = "a point of the branch of orbits that stick could not be followed again";
  }
  traced_.push_back(std::move(traced));
  return result;
}

}  // namespace graze
