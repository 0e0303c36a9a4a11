#include "graze/bifurcation/orbit_branches.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "graze/assembly/initial_state.hpp"
#include "graze/bifurcation/admissible_runs.hpp"
#include "graze/bifurcation/closed_form_survey.hpp"
#include "graze/bifurcation/found_branches.hpp"
#include "graze/bifurcation/pattern_switching.hpp"
#include "graze/bifurcation/speed_survey.hpp"
#include "graze/bifurcation/sticking_branches.hpp"
#include "graze/bifurcation/touching_orbit.hpp"
#include "graze/continuation/switching.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/closed_form.hpp"
#include "graze/orbit/settled.hpp"

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

// Forcing periods within which a motion has to repeat to count as one that sticks: each time it
// comes to rest it forgets what came before.
constexpr long long kPeriodsToStick = 300;

class OrbitTracer {
 public:
  OrbitTracer(const SystemFamily& family, const BranchOptions& options)
      : family_(family),
        options_(options),
        lowest_(std::min(options.from, options.to)),
        highest_(std::max(options.from, options.to)),
        scale_(shooting_scale(*family.at(family.value()))) {
    result_.parameter = family.parameter();
    result_.scale = scale_;
    result_.range = highest_ - lowest_;
    continuation_.from = options.from;
    continuation_.to = options.to;
    continuation_.max_step = options.max_step;
    continuation_.stop = options.stop;
    sticking_ = std::make_unique<StickingBranches>(family, continuation_, options.follow_depth > 0,
                                                   options.finder.max_impacts);
  }

  OrbitBranches trace() {
    if (options_.start)
      trace_from_special(*options_.start);
    else
      trace_from_search();
    follow();
    const double speed_scale = scale_.length * family_.at(family_.value())->forcing->frequency;
    result_.branches =
        put_in_order(std::move(found_), Components(highest_ - lowest_, speed_scale),
                     [this](const OrbitBranch& branch) { return connected_set(branch); });
    // What the simulation does is worth a line only where it explains that there is nothing else.
    if (!result_.branches.empty()) result_.notes.clear();
    if (options_.impacts == 1)
      result_.notes.push_back(in_words(result_.sought, family_.parameter(), options_.period));
    for (const std::string& note : sticking_notes_) result_.notes.push_back(note);
    result_.stopped = options_.stop.reason();
    return std::move(result_);
  }

 private:
  void trace_from_search() {
    trace_from_values();
    if (options_.start_values > 0 && options_.finder.from_closed_form && options_.impacts == 1)
      trace_from_surveys();
  }

  // At the family's own value.
  void trace_from_special(const BranchStart& start) {
    if (start.at.sticking)
      trace_from_section(*start.at.sticking);
    else
      trace_from_impacts(start);
    if (found_.empty() && result_.notes.empty() && !options_.stop.requested())
      result_.notes.push_back(start.switched ? "no other branch was found there"
                                             : "the orbit there was not found again");
  }

  void trace_from_section(const SpecialOrbit::Sticking& section) {
    const double value = family_.value();
    const StickingOrbitAnswer answer =
        sticking_orbit_through(*family_.at(value), section.at_section, section.period,
                               {section.closure_speed, options_.finder.max_impacts, options_.stop});
    ++result_.starts;
    if (answer.orbit)
      add_sticking(*answer.orbit, value, 0, -1, 0);
    else
      sticking_notes_.insert(answer.why_not);
  }

  void trace_from_impacts(const BranchStart& start) {
    ++result_.starts;
    const double value = family_.value();
    const TouchingOrbit orbit = orbit_at(*family_.at(value), start.at);
    PatternBranches& branches = pattern_branches(canonical(orbit.pattern));
    const std::vector<ImpactPoint> impacts = in_canonical_order(orbit.pattern, orbit.impacts);
    const std::optional<BranchPoint> point = solution_at(branches, impacts, start);
    if (!point) return;
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

  // What is traced or switched from at a special point.
  std::optional<BranchPoint> solution_at(const PatternBranches& branches,
                                         const std::vector<ImpactPoint>& impacts,
                                         const BranchStart& start) const {
    const double value = family_.value();
    const auto along = start.same_parameter ? start.at.along : std::nullopt;
    if (start.at.kind != SpecialKind::kBranchPoint)
      return branches.solve_near(impacts, value, along);
    if (!along) return {};
    return branches.crossing(impacts, value, *along);
  }

  // The scene's own value, and values spread over the range.
  void trace_from_values() {
    std::vector<double> values;
    if (family_.value() >= lowest_ && family_.value() <= highest_)
      values.push_back(family_.value());
    for (int i = 0; i < options_.start_values; ++i)
      values.push_back(lowest_ + (highest_ - lowest_) * i / std::max(options_.start_values - 1, 1));
    result_.sought.start_values = static_cast<int>(values.size());
    if (options_.start_values > 1)
      result_.sought.start_spacing = (highest_ - lowest_) / (options_.start_values - 1);
    if (options_.finder.from_random) result_.sought.random_starts = kStartsOfOneImpact;
    for (std::size_t i = 0; i < values.size() && !options_.stop.requested(); ++i) {
      if (options_.progress)
        options_.progress(static_cast<double>(i) / static_cast<double>(values.size() + 1));
      for (const Orbit& orbit : orbits_at(values[i], i == 0))
        trace_from(orbit.pattern(), orbit.points(), values[i]);
      if (options_.sticking && options_.finder.from_simulation) trace_sticking(values[i]);
    }
  }

  void trace_from_surveys() {
    for (std::size_t stop = 0; stop < family_.scene().stops.size(); ++stop) {
      const int index = static_cast<int>(stop);
      if (!family_.at(family_.value())->stops[stop].restitution.is_constant()) {
        trace_from_speeds(index);
        continue;
      }
      ClosedFormSurvey& survey =
          surveys_
              .emplace(std::piecewise_construct, std::forward_as_tuple(index),
                       std::forward_as_tuple(family_, index, options_.period, lowest_, highest_))
              .first->second;
      if (options_.keep_virtual)
        survey.start_in_every_range();
      else if (bounded_runs(*family_.at(family_.value()), index))
        result_.sought.add(search_runs(family_, survey.ranges(), run_tracer(index)));
      else
        survey.start_in_every_run();
      result_.sought.add(survey);
      for (const ClosedFormSurvey::Start& start : survey.starts()) {
        if (options_.stop.requested()) return;
        if (!trace_from({options_.period, {index}}, {start.point}, start.value))
          ++result_.sought.lost;
      }
    }
  }

  void trace_from_speeds(int stop) {
    const SpeedSurvey survey =
        survey_speeds(family_, stop, options_.period, lowest_, highest_, options_.keep_virtual);
    result_.sought.add(survey);
    for (const SpeedSurvey::Start& start : survey.starts) {
      if (options_.stop.requested()) return;
      if (!trace_from({options_.period, {stop}}, {start.point}, start.value)) ++result_.sought.lost;
    }
  }

  // Traces orbits on one stop and says what branches of them there are.
  RunTracer run_tracer(int stop) {
    const ImpactPattern pattern{options_.period, {stop}};
    RunTracer tracer;
    tracer.trace = [this, pattern](const ImpactPoint& point, double value) {
      trace_from(pattern, {point}, value);
    };
    tracer.news = [this, pattern, next = std::size_t{0}](const auto& hand_over) mutable {
      for (; next < found_.size(); ++next) {
        const ImpactPattern& other = found_[next].branch.pattern;
        if (found_[next].pattern && other.period == pattern.period && other.stops == pattern.stops)
          hand_over(found_[next].branch);
      }
    };
    tracer.stopped = [this] { return options_.stop.requested(); };
    return tracer;
  }

  // Orbits at one value; the simulation and the random guesses join in at the first one only.
  std::vector<Orbit> orbits_at(double value, bool first) {
    const std::optional<System> system = family_.at(value);
    if (!system) return {};
    FinderOptions finder = options_.finder;
    finder.period = options_.period;
    finder.impacts = options_.impacts;
    finder.keep_virtual = true;
    finder.stop = options_.stop;
    if (!first && options_.impacts == 1) {
      // Random guesses cost more than all else; elsewhere they stand in where the closed form
      // cannot.
      finder.from_random =
          finder.from_random && !(finder.from_closed_form && has_closed_forms(*system));
    }
    std::optional<State> start;
    if (first || options_.impacts > 1) start = clear_start(family_.scene(), *system);
    if (start) finder.closure_speed = closure_speed(*system, *start);
    FoundOrbits found = find_orbits(*system, start, finder);
    // Those have branches of their own.
    const auto sticks = [](const Orbit& orbit) { return orbit.sticking.has_value(); };
    found.orbits.erase(std::remove_if(found.orbits.begin(), found.orbits.end(), sticks),
                       found.orbits.end());
    if (first) result_.notes = found.notes;
    return std::move(found.orbits);
  }

  // Whether the closed form holds at every stop.
  bool has_closed_forms(const System& system) const {
    for (std::size_t stop = 0; stop < system.stops.size(); ++stop)
      if (!closed_form(system, static_cast<int>(stop), options_.period).form) return false;
    return true;
  }

  PatternBranches& pattern_branches(const ImpactPattern& pattern) {
    auto& place = patterns_[{pattern.period, pattern.stops}];
    if (!place)
      place = std::make_unique<PatternBranches>(family_, pattern, scale_, continuation_,
                                                options_.keep_virtual);
    return *place;
  }

  // Traces the branch through the solution near these impacts, unless it is known already or is
  // none. Whether there is a solution.
  bool trace_from(const ImpactPattern& pattern, const std::vector<ImpactPoint>& impacts,
                  double value) {
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

  // As asked for, or by the scene's tolerance.
  double closure_speed(const System& system, const State& start) const {
    return options_.finder.closure_speed.value_or(
        default_closure_speed(system, start, family_.scene().solver.tolerance));
  }

  // Traces the branch of the orbit that sticks, where the motion from the scene's initial state
  // settles on one.
  void trace_sticking(double value) {
    const std::optional<System> system = family_.at(value);
    if (!system) return;
    const std::optional<State> start = clear_start(family_.scene(), *system);
    if (!start) return;
    SettleOptions settling;
    settling.periods = kPeriodsToStick;
    settling.max_impacts = options_.finder.max_impacts;
    settling.closure_speed = closure_speed(*system, *start);
    settling.stop = options_.stop;
    const SettledMotion settled = settle(*system, *start, settling);
    if (settled.kind != SettledKind::kSticks) return;
    const StickingOrbitAnswer answer =
        sticking_orbit(*system, settled.at_start, settled.period,
                       {*settling.closure_speed, settling.max_impacts, options_.stop});
    if (!answer.orbit || answer.orbit->period != options_.period) return;
    ++result_.starts;
    add_sticking(*answer.orbit, value, 0, -1, 0);
  }

  // Traces the branch of an orbit that sticks unless it is known, and with `follow_depth` those
  // beyond its ends.
  void add_sticking(const Orbit& orbit, double value, int depth, int origin_branch,
                    std::size_t origin_special) {
    StickingTrace trace = sticking_->trace(orbit, value);
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

  // Traces from a start and keeps the parts. The origin: a special point, where there is one.
  void add_trace(PatternBranches& branches, const BranchPoint& start, Directions directions,
                 int origin_branch, std::size_t origin_special) {
    add_parts(branches, branches.trace(start, directions), directions, origin_branch,
              origin_special);
  }

  void add_parts(PatternBranches& branches, const Branch& branch, Directions directions,
                 int origin_branch, std::size_t origin_special) {
    const auto is_cut = [](BranchEnd end) {
      return end == BranchEnd::kStepLimit || end == BranchEnd::kNotConverged;
    };
    // Where a trace goes one way only, it has no other end.
    bool cut =
        is_cut(branch.ends[1]) || (directions == Directions::kBoth && is_cut(branch.ends[0]));
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

  // Switches at the special points, those of one depth after the other.
  void follow() {
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

  void switch_at(std::size_t index, std::size_t which) {
    const SpecialPoint special = found_[index].branch.special[which];
    switch_from(found_[index].pattern->equations(), special, static_cast<int>(index), which);
  }

  // The origin as of add_trace.
  void switch_from(const OrbitEquations& known, const SpecialPoint& special, int origin_branch,
                   std::size_t origin_special) {
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
    // Either way from a doubling lead the same orbits, half a period apart.
    add_trace(branches, *start, doubling ? Directions::kForward : Directions::kBoth, origin_branch,
              origin_special);
  }

  // Branches that were traced apart may be connected where the solutions are no orbits; the closed
  // form knows.
  std::optional<std::pair<int, int>> connected_set(const OrbitBranch& branch) const {
    const int stop = branch.pattern.stops.front();
    const OrbitBranchPoint& middle = branch.points[branch.points.size() / 2];
    const auto survey = surveys_.find(stop);
    if (survey == surveys_.end() || options_.keep_virtual) return {};
    const std::optional<int> name =
        survey->second.ranges().component(middle.value, middle.orbit.impacts.front().phase);
    if (!name) return {};
    return std::pair(stop, *name);
  }

  const SystemFamily& family_;
  const BranchOptions& options_;
  double lowest_, highest_;
  ShootingScale scale_;
  ContinuationOptions continuation_;
  std::map<std::pair<int, std::vector<int>>, std::unique_ptr<PatternBranches>> patterns_;
  std::unique_ptr<StickingBranches> sticking_;
  std::set<std::string> sticking_notes_;     // why one was not continued
  std::map<int, ClosedFormSurvey> surveys_;  // by stop
  std::vector<FoundBranch> found_;
  OrbitBranches result_;
};

}  // namespace

OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options) {
  return OrbitTracer(family, options).trace();
}

}  // namespace graze
