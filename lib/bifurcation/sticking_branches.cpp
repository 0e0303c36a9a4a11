#include "graze/bifurcation/sticking_branches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/orbit_parts.hpp"
#include "graze/bifurcation/sticking_borders.hpp"
#include "graze/continuation/critical.hpp"

namespace graze {
namespace {

class StickingParts {
 public:
  StickingParts(const StickingEquations& equations, const ContinuationOptions& options,
                const Branch& branch)
      : equations_(equations), options_(options), branch_(branch), borders_(equations, options) {}

  // Nothing where a point of it cannot be judged. Adds what lies beyond its ends.
  std::optional<OrbitBranch> judge(std::vector<StickingNeighbour>& neighbours) {
    const std::size_t last = branch_.points.size() - 1;
    const bool cut_front = branch_.ends[0] == BranchEnd::kHalted,
               cut_back = branch_.ends[1] == BranchEnd::kHalted;
    const std::size_t first = cut_front ? 1 : 0, end = cut_back ? last - 1 : last;
    const std::array<StickingTip, 2> tips = {tip(0, first, 0), tip(1, end, last)};
    OrbitBranch result;
    result.pattern.period = equations_.section().release().period;
    result.ends = {tips[0].end, tips[1].end};
    add_border(tips[0], result, neighbours);
    if (cut_front && tips[0].border) add_last_step(*tips[0].border, branch_.points[first], result);
    auto critical = branch_.critical.begin();
    while (critical != branch_.critical.end() && critical->after < first) ++critical;
    for (std::size_t i = first; i <= end; ++i) {
      const std::optional<OrbitBranchPoint> point = equations_.judge(branch_.points[i]);
      if (!point) return {};
      result.points.push_back(*point);
      for (; critical != branch_.critical.end() && critical->after == i && i < end; ++critical)
        add_critical(*critical, result);
    }
    if (cut_back && tips[1].border) add_last_step(branch_.points[end], *tips[1].border, result);
    add_border(tips[1], result, neighbours);
    const std::optional<ReleaseReturn> back = equations_.follow(branch_.points[first]);
    if (!back) return {};
    result.holds = back->holds;
    return result;
  }

 private:
  // `inner`: the last point that is an orbit; `outer`: the first beyond, where the trace was
  // halted.
  StickingTip tip(std::size_t side, std::size_t inner, std::size_t outer) {
    const BranchEnd end = branch_.ends[side];
    if (end == BranchEnd::kHalted)
      return borders_.between(branch_.points[inner], branch_.points[outer]);
    if (end == BranchEnd::kNotConverged) {
      std::vector<BranchPoint> reached(branch_.points.begin(), branch_.points.end());
      if (side == 0) std::reverse(reached.begin(), reached.end());
      return borders_.at_last(reached);
    }
    StickingTip tip;
    tip.end = as_orbit_end(end);
    return tip;
  }

  void add_border(const StickingTip& tip, OrbitBranch& result,
                  std::vector<StickingNeighbour>& neighbours) const {
    if (!tip.border) return;
    std::optional<OrbitBranchPoint> at = equations_.judge(*tip.border);
    if (!at) return;
    at->value = tip.value;
    // A trace that came to its end there has the point already.
    if (result.points.empty() || result.points.back().value != at->value)
      result.points.push_back(*at);
    const SpecialKind kind = tip.end == OrbitBranchEnd::kGrazing ? SpecialKind::kGrazing
                                                                 : SpecialKind::kChatterCompletes;
    result.special.push_back({kind, "", *at, {}, tip.by_speed, *tip.border, tip.interrupted});
    if (!tip.beyond) return;
    if (std::optional<OrbitBranchPoint> other = equations_.judge(*tip.beyond))
      neighbours.push_back({result.special.size() - 1, std::move(other->orbit), other->value});
  }

  // The special points between the last orbit of the trace and the border, whichever comes first.
  // The trace's own last step leads beyond it.
  void add_last_step(BranchPoint a, BranchPoint b, OrbitBranch& result) {
    const ZeroProblem& problem = equations_.problem();
    Corrector corrector(problem, options_);
    const Vector chord = corrector.difference(corrector.pack(b), corrector.pack(a));
    Branch step;
    for (BranchPoint* point : {&a, &b}) {
      if (point->tangent.dot(chord) < 0.0) {
        point->tangent *= -1.0;
        point->orientation *= -1;
      }
      point->multipliers = problem.multipliers(point->u, point->parameter, ErrorBounds::kGiven);
      step.points.push_back(*point);
    }
    const auto rate = [](const BranchPoint& p) { return p.tangent[p.tangent.size() - 1]; };
    if (rate(a) * rate(b) < 0.0)
      if (const auto fold = locate(problem, options_, a, b, rate))
        step.critical.push_back({CriticalKind::kFold, *fold, 0, {}});
    add_critical_points(step, problem, corrector);
    for (const CriticalPoint& critical : step.critical) add_critical(critical, result);
  }

  void add_critical(const CriticalPoint& critical, OrbitBranch& result) const {
    if (!is_of_orbits(critical)) return;
    const std::optional<OrbitBranchPoint> at = equations_.judge(critical.point);
    if (!at) return;
    SpecialPoint special{as_special(critical.kind), "", *at, {}, false, critical.point};
    if (critical.multiplier) special.multiplier = critical.multiplier->value;
    result.points.push_back(*at);
    result.special.push_back(special);
  }

  const StickingEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& branch_;
  StickingBorders borders_;
};

// Where the trace was halted it is one point too long: it ends at the special point there, if it
// was located.
void cut_beyond(Branch& trace, const OrbitBranch& judged) {
  const auto located = [&](std::size_t side) {
    return judged.ends[side] == OrbitBranchEnd::kChatterCompletes ||
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

StickingEquations::StickingEquations(const SystemFamily& family, const System& reference,
                                     const Release& release, const StickingOptions& options)
    : family_(family), section_(reference, release, options) {
  problem_.evaluate = [this](const Vector& u, double value) -> std::optional<ZeroEvaluation> {
    const System* system = system_at(value);
    if (!system) return {};
    const std::optional<System> tangent = family_.tangent_at(value);
    if (!tangent) return {};
    const auto at = section_.evaluate(*system, u, &*tangent);
    if (!at) return {};
    return ZeroEvaluation{at->residual, at->jacobian, at->parameter_derivative};
  };
  // The errors of the eigenvalues come with them, whether or not they are asked for.
  problem_.multipliers = [this](const Vector& u, double value,
                                auto&&...) -> std::vector<Eigenvalue> {
    const System* system = system_at(value);
    return system ? section_.multipliers(*system, u) : std::vector<Eigenvalue>();
  };
  problem_.wrap = Vector::Zero(section_.size());
  problem_.wrap[0] = kTurn;
}

const System* StickingEquations::system_at(double value) const {
  if (!cached_ || value != cached_value_) {
    cached_ = family_.at(value);
    cached_value_ = value;
  }
  return cached_ ? &*cached_ : nullptr;
}

std::optional<ReleaseReturn> StickingEquations::follow(const BranchPoint& solution,
                                                       bool minima) const {
  const System* system = system_at(solution.parameter);
  if (!system) return {};
  return section_.follow(*system, solution.u, minima);
}

std::optional<OrbitBranchPoint> StickingEquations::judge(const BranchPoint& solution) const {
  const System* system = system_at(solution.parameter);
  if (!system) return {};
  std::optional<Orbit> orbit = section_.orbit(*system, solution.u);
  if (!orbit) return {};
  OrbitBranchPoint point;
  point.value = solution.parameter;
  point.unstable_multipliers = count_multipliers(orbit->multipliers).outside;
  point.smallest_speed = std::numeric_limits<double>::infinity();
  for (const OrbitImpact& impact : orbit->impacts)
    point.smallest_speed = std::min(point.smallest_speed, impact.speed);
  point.orbit = std::move(*orbit);
  return point;
}

bool StickingBranches::knows(const std::vector<OrbitRelease>& releases, double value) const {
  for (const Traced& traced : traced_)
    for (const OrbitRelease& at : releases) {
      const Release& known = traced.equations->section().release();
      if (at.release.period != known.period || at.release.closed != known.closed ||
          at.release.released != known.released)
        continue;
      const auto point = solve_at(traced.equations->problem(), range_,
                                  traced.equations->section().pack(at.theta, at.state), value);
      if (point && lies_on(traced.equations->problem(), range_, traced.branch, *point)) return true;
    }
  return false;
}

StickingTrace StickingBranches::trace(const Orbit& orbit, double value) {
  StickingTrace result;
  const std::optional<System> system = family_.at(value);
  if (!system || !orbit.sticking) return result;
  const StickingOptions options{orbit.sticking->closure_speed, 10'000'000, range_.stop};
  const std::vector<OrbitRelease> releases = releases_of(*system, orbit, options);
  if (releases.empty()) {
    result.why_not = "an orbit whose closed stops never let go is not continued";
    return result;
  }
  result.known = knows(releases, value);
  if (result.known) return result;
  Traced traced;
  traced.equations =
      std::make_unique<StickingEquations>(family_, *system, releases.front().release, options);
  const StickingEquations& equations = *traced.equations;
  ContinuationOptions range = range_;
  StickingBorders borders(equations, range_);
  range.proceed = [&borders](const BranchPoint& previous, const BranchPoint& here) {
    return !borders.passes(previous, here);
  };
  const auto start =
      solve_at(equations.problem(), range,
               equations.section().pack(releases.front().theta, releases.front().state), value);
  const std::optional<ReleaseReturn> back =
      start ? equations.follow(*start) : std::optional<ReleaseReturn>();
  if (!back || !back->returns) {
    result.why_not = "the orbit that sticks was not found again at its release";
    return result;
  }
  if (borders.has_shrunk(*back, *start)) {
    result.why_not =
        "an orbit with stuck phases without end (a chatter on one stop throws the structure off "
        "another) is not continued";
    return result;
  }
  traced.branch = trace_branch(equations.problem(), range, *start);
  result.branch = StickingParts(equations, range, traced.branch).judge(result.neighbours);
  result.evaluations = traced.branch.evaluations;
  result.rejected = traced.branch.rejected;
  if (!result.branch)
    result.why_not = "a point of the branch of orbits that stick could not be followed again";
  else
    result.cut_short =
        std::any_of(result.branch->ends.begin(), result.branch->ends.end(), [](auto end) {
          return end == OrbitBranchEnd::kNotConverged || end == OrbitBranchEnd::kStepLimit;
        });
  if (result.branch) cut_beyond(traced.branch, *result.branch);
  traced_.push_back(std::move(traced));
  return result;
}

}  // namespace graze
