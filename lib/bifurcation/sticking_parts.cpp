#include "graze/bifurcation/sticking_parts.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/orbit_parts.hpp"
#include "graze/bifurcation/sticking_borders.hpp"
#include "graze/continuation/critical.hpp"
#include "graze/continuation/switching.hpp"
#include "graze/orbit/held_force.hpp"

namespace graze {
namespace {

// A flight whose excursion, as its duration to the power 4, is within rounding is none: what that
// leaves of the parameter, as its duration to the power 2, is some 1e-8 of the range.
constexpr double kTold = 1e-6;
// Steps along a branch that leaves another, so that its orbits can be told from those of that one.
constexpr int kStepsAway = 3;
constexpr int kMostSecants = 16;  // each doubles the digits, nearly

class StickingParts {
 public:
  StickingParts(const StickingEquations& equations, const ContinuationOptions& options,
                const Branch& branch, bool switches, std::vector<StickingNeighbour>& neighbours)
      : equations_(equations),
        options_(options),
        branch_(branch),
        switches_(switches),
        neighbours_(neighbours),
        borders_(equations, options) {}

  // Nothing where a point of it cannot be judged.
  std::optional<OrbitBranch> judge() {
    const std::size_t last = branch_.points.size() - 1;
    const bool cut_front = branch_.ends[0] == BranchEnd::kHalted,
               cut_back = branch_.ends[1] == BranchEnd::kHalted;
    const std::size_t first = cut_front ? 1 : 0, end = cut_back ? last - 1 : last;
    const std::array<StickingTip, 2> tips = {tip(0, first, 0), tip(1, end, last)};
    OrbitBranch result;
    result.pattern.period = equations_.section().release().period;
    result.ends = {tips[0].end, tips[1].end};
    add_border(tips[0], result);
    if (cut_front && leads_on(tips[0]))
      add_last_step(*tips[0].border, branch_.points[first], branch_.points[first], result);
    auto critical = branch_.critical.begin();
    while (critical != branch_.critical.end() && critical->after < first) ++critical;
    for (std::size_t i = first; i <= end; ++i) {
      const std::optional<OrbitBranchPoint> point = equations_.judge(branch_.points[i]);
      if (!point) return {};
      result.points.push_back(*point);
      if (i == end) break;
      std::vector<CriticalPoint> within;
      for (; critical != branch_.critical.end() && critical->after == i; ++critical)
        within.push_back(*critical);
      add_step(branch_.points[i], branch_.points[i + 1], within, result);
    }
    if (cut_back && leads_on(tips[1]))
      add_last_step(branch_.points[end], *tips[1].border, branch_.points[end], result);
    add_border(tips[1], result);
    const std::optional<ReleaseReturn> back = equations_.follow(branch_.points[first]);
    if (!back) return {};
    result.holds = back->holds;
    return result;
  }

 private:
  // Where the force that holds the structure at rest touches zero, and at which phase. Flights near
  // that are too short to tell from none; the force is smooth across it. `near` is a value within
  // what they tell.
  std::optional<std::pair<double, double>> lift_off(double near) const {
    const Release& release = equations_.section().release();
    const auto held_at = [&](double value) {
      const System* system = equations_.system_at(value);
      return system ? held_force(*system, release.closed, release.released)
                    : std::optional<HeldForce>();
    };
    const double range = std::abs(options_.to - options_.from);
    double before = near - kTold * range, value = near;
    for (int step = 0; step < kMostSecants; ++step) {
      const std::optional<HeldForce> a = held_at(before), b = held_at(value);
      if (!a || !b) return {};
      if (a->least() == b->least()) break;
      const double next = value - b->least() * (value - before) / (b->least() - a->least());
      if (!(std::abs(next - near) <= kTold * range)) return {};
      before = value;
      value = next;
      if (value == before) break;
    }
    const std::optional<HeldForce> there = held_at(value);
    if (!there) return {};
    return std::pair(value, there->phase_of_least());
  }

  // `inner`: the last point that is an orbit; `outer`: the first beyond, where the trace was
  // halted.
  StickingTip tip(std::size_t side, std::size_t inner, std::size_t outer) {
    const BranchEnd end = branch_.ends[side];
    if (end == BranchEnd::kHalted &&
        equations_.passes_half(branch_.points[inner], branch_.points[outer]))
      return joins_half(branch_.points[inner], branch_.points[outer]);
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

  // Where the orbits have half the period, between neighbours on either side of it. The equations
  // are singular there and passed in a step so short that the branch is straight over it.
  StickingTip joins_half(const BranchPoint& inner, const BranchPoint& outer) const {
    const double before = equations_.halves_differ(inner).norm();
    const double part = before / (before + equations_.halves_differ(outer).norm());
    BranchPoint at = inner;
    at.u += part * (outer.u - inner.u);
    at.parameter += part * (outer.parameter - inner.parameter);
    return {OrbitBranchEnd::kPeriodDoubling, at, false, false, at.parameter, {}};
  }

  void add_border(const StickingTip& tip, OrbitBranch& result) const {
    if (!tip.border) return;
    std::optional<OrbitBranchPoint> at = equations_.judge(*tip.border);
    if (!at) return;
    at->value = tip.value;
    if (tip.end == OrbitBranchEnd::kPeriodDoubling) {
      result.points.push_back(*at);
      return;
    }
    BranchPoint solution = *tip.border;
    if (tip.end == OrbitBranchEnd::kAtRest)
      if (const auto there = lift_off(tip.value)) {
        at->value = solution.parameter = there->first;
        solution.u[0] = there->second;
      }
    // A trace that came to its end there has the point already.
    if (result.points.empty() || result.points.back().value != at->value)
      result.points.push_back(*at);
    const SpecialKind kind = tip.end == OrbitBranchEnd::kGrazing  ? SpecialKind::kGrazing
                             : tip.end == OrbitBranchEnd::kAtRest ? SpecialKind::kLiftOff
                                                                  : SpecialKind::kChatterCompletes;
    result.special.push_back({kind, "", *at, {}, tip.by_speed, solution, tip.interrupted});
    if (!tip.beyond) return;
    if (std::optional<OrbitBranchPoint> other = equations_.judge(*tip.beyond))
      neighbours_.push_back({result.special.size() - 1, std::move(other->orbit), other->value});
  }

  // Whether special points may lie before it: at an orbit of half the period the equations have one
  // of their own.
  static bool leads_on(const StickingTip& tip) {
    return tip.border && tip.end != OrbitBranchEnd::kPeriodDoubling;
  }

  // The special points between the last orbit of the trace and the border, whichever comes first.
  // The trace's own last step leads beyond it.
  void add_last_step(BranchPoint a, BranchPoint b, const BranchPoint& orbit, OrbitBranch& result) {
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
    add_critical_points(step, problem, corrector, options_.stop);
    // Where the border is a fold of the equations (a flight that goes as the root of the distance)
    // solutions beside it may lie beyond.
    const std::optional<ReleaseReturn> here = equations_.follow(orbit);
    std::erase_if(step.critical, [&](const CriticalPoint& critical) {
      const std::optional<ReleaseReturn> there = equations_.follow(critical.point);
      return !here || !there || there->holds != here->holds;
    });
    add_step(a, b, step.critical, result);
  }

  // The special points between two orbits: those of the equations, and grazings that they pass.
  void add_step(const BranchPoint& a, const BranchPoint& b,
                const std::vector<CriticalPoint>& criticals, OrbitBranch& result) {
    Corrector corrector(equations_.problem(), options_);
    const auto along = [&](const BranchPoint& point) {
      return corrector.difference(corrector.pack(point), corrector.pack(a)).norm();
    };
    const std::vector<StickingTip> passed = borders_.passed(a, b);
    auto grazing = passed.begin();
    for (const CriticalPoint& critical : criticals) {
      for (; grazing != passed.end() && along(*grazing->border) < along(critical.point); ++grazing)
        add_grazing(*grazing, result);
      add_critical(critical, result);
    }
    for (; grazing != passed.end(); ++grazing) add_grazing(*grazing, result);
  }

  void add_grazing(const StickingTip& tip, OrbitBranch& result) const {
    std::optional<OrbitBranchPoint> at = equations_.judge(*tip.border);
    if (!at) return;
    at->value = tip.value;
    result.points.push_back(*at);
    result.special.push_back({SpecialKind::kGrazing, "", *at, {}, tip.by_speed, *tip.border});
  }

  void add_critical(const CriticalPoint& critical, OrbitBranch& result) const {
    if (!is_of_orbits(critical)) return;
    const std::optional<OrbitBranchPoint> at = equations_.judge(critical.point);
    if (!at) return;
    SpecialPoint special{as_special(critical.kind), "", *at, {}, false, critical.point};
    if (critical.multiplier) special.multiplier = critical.multiplier->value;
    result.points.push_back(*at);
    result.special.push_back(special);
    if (switches_) add_neighbour(critical, result.special.size() - 1);
  }

  // An orbit a step along the branch that leaves this one there.
  void add_neighbour(const CriticalPoint& critical, std::size_t special) const {
    const bool doubles = critical.kind == CriticalKind::kPeriodDoubling;
    if (!doubles && critical.kind != CriticalKind::kBranchPoint) return;
    const std::unique_ptr<StickingEquations> twice =
        doubles ? equations_.doubled() : std::unique_ptr<StickingEquations>();
    const StickingEquations& next = doubles ? *twice : equations_;
    BranchPoint at = critical.point;
    at.multipliers.clear();
    const std::optional<BranchPoint> start = other_branch(next.problem(), options_, at);
    if (!start) return;
    ContinuationOptions some = options_;
    some.max_points = kStepsAway;
    some.proceed = {};
    ZeroProblem problem = next.problem();
    problem.multipliers = nullptr;
    const BranchPoint away =
        trace_branch(problem, some, *start, Directions::kForward).points.back();
    if (std::optional<OrbitBranchPoint> other = next.judge(away))
      neighbours_.push_back({special, std::move(other->orbit), other->value});
  }

  const StickingEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& branch_;
  bool switches_;
  std::vector<StickingNeighbour>& neighbours_;
  StickingBorders borders_;
};

}  // namespace

std::optional<OrbitBranch> judge_sticking(const StickingEquations& equations,
                                          const ContinuationOptions& options, const Branch& branch,
                                          bool switches,
                                          std::vector<StickingNeighbour>& neighbours) {
  return StickingParts(equations, options, branch, switches, neighbours).judge();
}

}  // namespace graze
