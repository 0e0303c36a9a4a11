#include "graze/bifurcation/sticking_branches.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/sticking_borders.hpp"
#include "graze/bifurcation/sticking_parts.hpp"

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

StickingEquations::StickingEquations(const SystemFamily& family, ReleaseSection section)
    : family_(family), section_(std::move(section)) {
  const int period = section_.release().period;
  if (period % 2 == 0) half_ = section_.over(period / 2);
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

Vector StickingEquations::halves_differ(const BranchPoint& solution) const {
  const System* system = half_ ? system_at(solution.parameter) : nullptr;
  if (!system) return {};
  const auto at = half_->evaluate(*system, solution.u);
  return at ? at->residual : Vector();
}

bool StickingEquations::passes_half(const BranchPoint& a, const BranchPoint& b) const {
  const Vector before = halves_differ(a), now = halves_differ(b);
  return before.size() > 0 && before.size() == now.size() && before.dot(now) < 0.0;
}

std::optional<ReleaseReturn> StickingEquations::follow(const BranchPoint& solution,
                                                       bool minima) const {
  for (const Followed& known : followed_)
    if (known.parameter == solution.parameter && known.minima == minima && known.u == solution.u)
      return known.back;
  const System* system = system_at(solution.parameter);
  if (!system) return {};
  // Both ends of a step, and a solution between.
  if (followed_.size() == 3) followed_.pop_front();
  followed_.push_back(
      {solution.u, solution.parameter, minima, section_.follow(*system, solution.u, minima)});
  return followed_.back().back;
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

std::optional<std::vector<PassageMargin>> StickingEquations::margins(const BranchPoint& solution,
                                                                     double range) const {
  const System* system = system_at(solution.parameter);
  const std::optional<System> tangent =
      system ? family_.tangent_at(solution.parameter) : std::optional<System>();
  if (!tangent) return {};
  const Eigen::Index n = solution.u.size();
  return section_.margins(*system, solution.u, *tangent, solution.tangent.head(n),
                          solution.tangent[n] * range);
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
  range.proceed = [&](const BranchPoint& previous, const BranchPoint& here) {
    return !equations.passes_half(previous, here) && !borders.passes(previous, here);
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
  result.branch = judge_sticking(equations, range, traced.branch, switches_, result.neighbours);
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
