#include "graze/bifurcation/branch_collector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/bifurcation/pattern_switching.hpp"
#include "graze/bifurcation/special_names.hpp"
#include "graze/bifurcation/touching_orbit.hpp"
#include "graze/continuation/switching.hpp"
#include "graze/orbit/followed_orbit.hpp"

namespace graze {
namespace {

// The orbit of a special point; without its touch where that was found on a locus of grazing,
// unless the motion meets no stop but there.
TouchingOrbit orbit_at(const System& system, const SpecialOrbit& special) {
  TouchingOrbit orbit{special.pattern, special.impacts, 0};
  if (special.locus != OrbitLocusKind::kGrazing || orbit.impacts.size() == 1) return orbit;
  orbit.touch = admissibility(system, orbit.pattern, orbit.impacts).slowest;
  return without_touch(std::move(orbit));
}

ContinuationOptions range_of(const BranchOptions& options) {
  ContinuationOptions range;
  range.from = options.from;
  range.to = options.to;
  range.max_step = options.max_step;
  range.stop = options.stop;
  return range;
}

}  // namespace

BranchCollector::BranchCollector(const SystemFamily& family, const BranchOptions& options,
                                 OrbitBranches& result)
    : family_(family),
      options_(options),
      result_(result),
      continuation_(range_of(options)),
      sticking_(family, continuation_, options.follow_depth > 0, options.finder.max_impacts) {
  result_.scale = motion_scale(*family.at(family.value()));
  result_.range = std::abs(options.to - options.from);
}

PatternBranches& BranchCollector::pattern_branches(const ImpactPattern& pattern) {
  auto& place = patterns_[{pattern.period, pattern.stops}];
  if (!place)
    place = std::make_unique<PatternBranches>(family_, pattern, result_.scale, continuation_,
                                              options_.keep_virtual);
  return *place;
}

bool BranchCollector::trace_from(const ImpactPattern& pattern,
                                 const std::vector<ImpactPoint>& impacts, double value) {
  ++result_.starts;
  PatternBranches& branches = pattern_branches(canonical(pattern));
  const auto start = branches.solve(in_canonical_order(pattern, impacts), value);
  if (!start) return false;
  if (!branches.lists(*start))
    ++result_.virtual_starts;
  else if (!branches.knows(*start))
    add_trace(branches, *start, Directions::kBoth, -1, 0);
  return true;
}

void BranchCollector::trace_from_sticking(const Orbit& orbit, double value) {
  ++result_.starts;
  add_sticking(orbit, value, 0, -1, 0);
}

void BranchCollector::trace_from_special(const BranchStart& start) {
  if (start.at.sticks())
    trace_from_section(*start.at.followed);
  else
    trace_from_impacts(start);
  if (found_.empty() && result_.notes.empty() && sticking_notes_.empty() &&
      !options_.stop.requested())
    result_.notes.push_back(start.switched ? "no other branch was found there"
                                           : "the orbit there was not found again, or is none of "
                                             "the system beyond that point on either side");
}

void BranchCollector::trace_from_section(const SpecialOrbit::Followed& section) {
  const double value = family_.value();
  const FollowedAnswer answer =
      orbit_through(*family_.at(value), section.states.front(), section.period,
                    {section.closure_speed, options_.finder.max_impacts, options_.stop});
  if (answer.orbit)
    trace_from_sticking(*answer.orbit, value);
  else
    sticking_notes_.insert(answer.why_not);
}

void BranchCollector::trace_from_impacts(const BranchStart& start) {
  ++result_.starts;
  const double value = family_.value();
  const TouchingOrbit orbit = orbit_at(*family_.at(value), start.at);
  PatternBranches& branches = pattern_branches(canonical(orbit.pattern));
  const std::vector<ImpactPoint> impacts = in_canonical_order(orbit.pattern, orbit.impacts);
  const std::optional<BranchPoint> point = solution_at(branches, impacts, start);
  if (!point) return;
  // At a grazing rounding decides.
  if (start.at.label != label_of(SpecialKind::kGrazing) && !branches.lists(*point)) {
    ++result_.virtual_starts;
    result_.notes.push_back(
        "the solution there is no orbit of the system (penetrating or impacting at negative "
        "speed); --virtual goes on from it");
    return;
  }
  if (!start.switched) {
    add_parts(branches,
              start.at.kind == SpecialKind::kBranchPoint
                  ? branches.trace_across(*point)
                  : branches.trace(*point, Directions::kBoth),
              Directions::kBoth, -1, 0);
    return;
  }
  SpecialPoint special;
  special.kind = start.at.kind.value_or(SpecialKind::kFold);
  special.by_speed = start.at.by_speed;
  special.by_push = start.at.by_push;
  special.solution = *point;
  switch_from(branches.equations(), special, -1, 0);
}

std::optional<BranchPoint> BranchCollector::solution_at(const PatternBranches& branches,
                                                        const std::vector<ImpactPoint>& impacts,
                                                        const BranchStart& start) const {
  const double value = family_.value();
  const auto along = start.same_parameter ? start.at.along : std::nullopt;
  if (start.at.kind != SpecialKind::kBranchPoint) return branches.solve_near(impacts, value, along);
  if (!along) return {};
  return branches.crossing(impacts, value, *along);
}

void BranchCollector::add_sticking(const Orbit& orbit, double value, int depth, int origin_branch,
                                   std::size_t origin_special) {
  StickingTrace trace = sticking_.trace(orbit, value);
  if (trace.known) return;
  result_.shooting_evaluations += trace.evaluations;
  result_.rejected_steps += trace.rejected;
  if (!trace.branch) {
    if (options_.stop.requested()) return;
    sticking_notes_.insert(trace.why_not);
    return;
  }
  const int index = static_cast<int>(found_.size());
  found_.push_back(
      {std::move(*trace.branch), nullptr, result_.traced++, origin_branch, origin_special});
  if (trace.cut_short) ++result_.cut_short;
  if (origin_branch >= 0) ++result_.switched;
  for (const StickingNeighbour& other : trace.neighbours) {
    if (depth < options_.follow_depth)
      add_sticking(other.orbit, other.value, depth + 1, index, other.special);
    else
      result_.left_open += options_.follow_depth > 0 ? 1 : 0;
  }
}

void BranchCollector::add_trace(PatternBranches& branches, const BranchPoint& start,
                                Directions directions, int origin_branch,
                                std::size_t origin_special) {
  add_parts(branches, branches.trace(start, directions), directions, origin_branch, origin_special);
}

void BranchCollector::add_parts(PatternBranches& branches, const Branch& branch,
                                Directions directions, int origin_branch,
                                std::size_t origin_special) {
  const auto is_cut = [](BranchEnd end) {
    return end == BranchEnd::kStepLimit || end == BranchEnd::kNotConverged;
  };
  // Where a trace goes one way only, it has no other end.
  bool cut = is_cut(branch.ends[1]) || (directions == Directions::kBoth && is_cut(branch.ends[0]));
  result_.shooting_evaluations += branch.evaluations;
  result_.rejected_steps += branch.rejected;
  for (OrbitBranch& part : branches.parts(branch)) {
    cut = cut || part.ends[0] == OrbitBranchEnd::kNotConverged ||
          part.ends[1] == OrbitBranchEnd::kNotConverged;
    result_.meetings += static_cast<int>(
        std::count(part.ends.begin(), part.ends.end(), OrbitBranchEnd::kImpactsMeet));
    found_.push_back({std::move(part), &branches, result_.traced, origin_branch, origin_special});
  }
  ++result_.traced;
  if (cut) ++result_.cut_short;
}

void BranchCollector::follow() {
  std::size_t first = 0;
  for (int depth = 0; depth < options_.follow_depth; ++depth) {
    const std::size_t last = found_.size();
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < found_[i].branch.special.size() && found_[i].pattern; ++k) {
        if (options_.stop.requested()) return;
        switch_at(i, k);
      }
    first = last;
  }
  for (std::size_t i = first; i < found_.size() && options_.follow_depth > 0; ++i)
    for (const SpecialPoint& special : found_[i].branch.special)
      result_.left_open +=
          found_[i].pattern && pattern_switch(found_[i].pattern->equations(), special) ? 1 : 0;
}

void BranchCollector::switch_at(std::size_t index, std::size_t which) {
  const SpecialPoint special = found_[index].branch.special[which];
  switch_from(found_[index].pattern->equations(), special, static_cast<int>(index), which);
}

void BranchCollector::switch_from(const OrbitEquations& known, const SpecialPoint& special,
                                  int origin_branch, std::size_t origin_special) {
  const std::optional<PatternSwitch> next = pattern_switch(known, special);
  if (!next) return;
  PatternBranches& branches = pattern_branches(canonical(next->pattern));
  const OrbitEquations& equations = branches.equations();
  const std::vector<ImpactPoint> impacts = in_canonical_order(next->pattern, next->impacts);
  std::optional<BranchPoint> start;
  if (next->known_tangent.size() == 0) {
    start = solve_at(equations.problem(), branches.options(), equations.shooting().pack(impacts),
                     special.solution.parameter);
  } else {
    BranchPoint at = special.solution;
    at.u = equations.shooting().pack(impacts);
    at.tangent = next->known_tangent;
    at.multipliers.clear();
    start = other_branch(equations.problem(), branches.options(), at);
  }
  if (!start) return;
  // At a branch point the known branch passes too.
  const bool crossing = special.kind == SpecialKind::kBranchPoint;
  const bool doubling = special.kind == SpecialKind::kPeriodDoubling;
  if (crossing   ? branches.knows_crossing(*start)
      : doubling ? branches.knows_doubling(*start)
                 : branches.knows(*start))
    return;
  result_.switched += origin_branch >= 0 ? 1 : 0;
  // Of a start that is given nothing else is known; its own branch has it among its points.
  if (crossing && origin_branch < 0) {
    add_parts(branches, branches.trace_across(*start), Directions::kBoth, -1, 0);
    return;
  }
  // Either way from a doubling lead the same orbits, half a period apart.
  add_trace(branches, *start, doubling ? Directions::kForward : Directions::kBoth, origin_branch,
            origin_special);
}

}  // namespace graze
