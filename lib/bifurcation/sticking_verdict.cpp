#include "graze/bifurcation/sticking_verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "graze/bifurcation/sticking_borders.hpp"
#include "graze/bifurcation/sticking_completion.hpp"
#include "graze/bifurcation/sticking_switching.hpp"
#include "graze/continuation/critical.hpp"
#include "graze/continuation/locate.hpp"

namespace graze {
namespace {

class StickingJudge {
 public:
  StickingJudge(const PassageEquations& equations, const ContinuationOptions& options,
                const Branch& branch, bool switches)
      : equations_(equations),
        options_(options),
        branch_(branch),
        switches_(switches),
        corrector_(equations.problem(), options),
        borders_(equations, options) {}

  std::optional<StickingVerdict> judge() {
    const std::size_t last = branch_.points.size() - 1;
    const bool cut_front = branch_.ends[0] == BranchEnd::kHalted,
               cut_back = branch_.ends[1] == BranchEnd::kHalted;
    const std::size_t first = cut_front ? 1 : 0, end = cut_back ? last - 1 : last;
    const std::array<StickingTip, 2> tips = {tip(0, first, 0), tip(1, end, last)};
    OrbitBranch& result = verdict_.branch;
    result.pattern.period = equations_.period();
    result.ends = {tips[0].end, tips[1].end};
    add_border(tips[0]);
    if (cut_front && leads_on(tips[0]))
      add_last_step(*tips[0].border, branch_.points[first], branch_.points[first]);
    if (!add_orbits(first, end)) return {};
    if (cut_back && leads_on(tips[1]))
      add_last_step(branch_.points[end], *tips[1].border, branch_.points[end]);
    add_border(tips[1]);
    const std::optional<ReleaseReturn> back = equations_.follow(branch_.points[first]);
    if (!back) return {};
    result.holds = back->holds;
    return std::move(verdict_);
  }

 private:
  // What ends the branch on a side. `inner`: the last point that is an orbit; `outer`: the first
  // beyond, where the trace was halted.
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

  // Whether special points may lie before it: at an orbit of half the period the equations have one
  // of their own.
  static bool leads_on(const StickingTip& tip) {
    return tip.border && tip.end != OrbitBranchEnd::kPeriodDoubling;
  }

  void add_border(const StickingTip& tip) {
    if (!tip.border) return;
    std::optional<OrbitBranchPoint> at = equations_.judge(*tip.border);
    if (!at) return;
    at->value = tip.value;
    std::vector<OrbitBranchPoint>& points = verdict_.branch.points;
    if (tip.end == OrbitBranchEnd::kPeriodDoubling) {
      points.push_back(*at);
      return;
    }
    BranchPoint solution = *tip.border;
    if (tip.end == OrbitBranchEnd::kAtRest) {
      const double range = std::abs(options_.to - options_.from);
      if (const auto there = lift_off(equations_, range, tip.value)) {
        at->value = solution.parameter = there->first;
        solution.u[0] = there->second;
      }
    }
    // A trace that came to its end there has the point already.
    if (points.empty() || points.back().value != at->value) points.push_back(*at);
    const SpecialKind kind = tip.end == OrbitBranchEnd::kGrazing  ? SpecialKind::kGrazing
                             : tip.end == OrbitBranchEnd::kAtRest ? SpecialKind::kLiftOff
                                                                  : SpecialKind::kChatterCompletes;
    verdict_.branch.special.push_back({kind, "", *at, {}, tip.by_speed, solution, tip.interrupted});
    if (tip.beyond) add_neighbour(equations_.judge(*tip.beyond));
  }

  // The orbits from point `first` to point `end`, and the special points between them; false where
  // one cannot be judged.
  bool add_orbits(std::size_t first, std::size_t end) {
    auto critical = branch_.critical.begin();
    while (critical != branch_.critical.end() && critical->after < first) ++critical;
    for (std::size_t i = first; i <= end; ++i) {
      const std::optional<OrbitBranchPoint> point = equations_.judge(branch_.points[i]);
      if (!point) return false;
      verdict_.branch.points.push_back(*point);
      if (i == end) break;
      std::vector<CriticalPoint> within;
      for (; critical != branch_.critical.end() && critical->after == i; ++critical)
        within.push_back(*critical);
      add_step(branch_.points[i], branch_.points[i + 1], within);
    }
    return true;
  }

  // The special points between the last orbit of the trace and the border, whichever comes first.
  // The trace's own last step leads beyond it.
  void add_last_step(BranchPoint a, BranchPoint b, const BranchPoint& orbit) {
    const ZeroProblem& problem = equations_.problem();
    const Vector chord = corrector_.chord(a, b);
    Branch step;
    for (BranchPoint* point : {&a, &b}) {
      if (point->tangent.dot(chord) < 0.0) point->turn_round();
      point->multipliers = problem.multipliers(point->u, point->parameters(), ErrorBounds::kGiven);
      step.points.push_back(*point);
    }
    if (const auto fold = fold_between(corrector_, a, b))
      step.critical.push_back({CriticalKind::kFold, *fold, 0, {}});
    add_critical_points(step, problem, corrector_, options_.stop);
    // Where the border is a fold of the equations (a flight that goes as the root of the distance)
    // solutions beside it may lie beyond.
    const std::optional<ReleaseReturn> here = equations_.follow(orbit);
    std::erase_if(step.critical, [&](const CriticalPoint& critical) {
      const std::optional<ReleaseReturn> there = equations_.follow(critical.point);
      return !here || !there || there->holds != here->holds;
    });
    add_step(a, b, step.critical);
  }

  // The special points between two orbits: those of the equations, and grazings that they pass.
  void add_step(const BranchPoint& a, const BranchPoint& b,
                const std::vector<CriticalPoint>& criticals) {
    const auto along = [&](const BranchPoint& point) { return corrector_.chord(a, point).norm(); };
    const std::vector<StickingTip> passed = borders_.passed(a, b);
    auto grazing = passed.begin();
    for (const CriticalPoint& critical : criticals) {
      for (; grazing != passed.end() && along(*grazing->border) < along(critical.point); ++grazing)
        add_grazing(*grazing);
      add_critical(critical);
    }
    for (; grazing != passed.end(); ++grazing) add_grazing(*grazing);
  }

  void add_grazing(const StickingTip& tip) {
    std::optional<OrbitBranchPoint> at = equations_.judge(*tip.border);
    if (!at) return;
    at->value = tip.value;
    verdict_.branch.points.push_back(*at);
    verdict_.branch.special.push_back(
        {SpecialKind::kGrazing, "", *at, {}, tip.by_speed, *tip.border});
  }

  void add_critical(const CriticalPoint& critical) {
    if (!is_of_orbits(critical)) return;
    std::optional<OrbitBranchPoint> at = equations_.judge(critical.point);
    if (!at) return;
    at = with_critical(std::move(*at), critical);
    verdict_.branch.points.push_back(*at);
    verdict_.branch.special.push_back(as_special(critical, *at));
    if (switches_) add_neighbour(orbit_beside(equations_, options_, critical));
  }

  // Of the last special point.
  void add_neighbour(std::optional<OrbitBranchPoint> other) {
    if (other)
      verdict_.neighbours.push_back(
          {verdict_.branch.special.size() - 1, std::move(other->orbit), other->value});
  }

  const PassageEquations& equations_;
  const ContinuationOptions& options_;
  const Branch& branch_;
  bool switches_;
  Corrector corrector_;
  StickingBorders borders_;
  StickingVerdict verdict_;
};

}  // namespace

std::optional<StickingVerdict> judge_sticking(const PassageEquations& equations,
                                              const ContinuationOptions& options,
                                              const Branch& branch, bool switches) {
  return StickingJudge(equations, options, branch, switches).judge();
}

}  // namespace graze
