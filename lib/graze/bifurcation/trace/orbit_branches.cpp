#include "graze/bifurcation/trace/orbit_branches.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/bifurcation/bounds/detail/admissible_runs.hpp"
#include "graze/bifurcation/bounds/detail/closed_form_survey.hpp"
#include "graze/bifurcation/bounds/detail/speed_survey.hpp"
#include "graze/bifurcation/problem/option_faults.hpp"
#include "graze/bifurcation/trace/detail/branch_collector.hpp"
#include "graze/bifurcation/trace/shown_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/search/detail/solved_orbit.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/orbit/search/settled.hpp"

namespace graze {
namespace {

// Forcing periods within which a motion has to repeat to count as one that sticks: each time it
// comes to rest it loses its memory of earlier motion.
constexpr long long kPeriodsToStick = 300;

// Number of values at which orbits are searched for at once.
constexpr std::size_t kValuesAtOnce = 8;

class OrbitTracer {
 public:
  OrbitTracer(const SystemFamily& family, const BranchOptions& options, const OrbitNumber& shown)
      : family_(family),
        options_(options),
        lowest_(std::min(options.from, options.to)),
        highest_(std::max(options.from, options.to)),
        branches_(family, options, shown, result_) {
    result_.parameter = family.parameter();
    result_.levels = names_of(options.levels);
    result_.has_normal_forms = options.normal_forms;
    const System own = *family.at(family.value());
    followed_ = !own.has_modal_flights();
    rubs_ = !own.frictions.empty();
    const State at_rest{Vector::Zero(own.modes()), Vector::Zero(own.modes())};
    closure_speed_ = options.finder.closure_speed.value_or(default_closure_speed(
        own, clear_start(family.scene(), own).value_or(at_rest), family.scene().solver.tolerance));
  }

  OrbitBranches trace() {
    if (options_.start) {
      branches_.trace_from_special(*options_.start);
    } else {
      trace_from_settled();
      for (const int impacts : wanted_impacts()) trace_from_search(impacts);
    }
    if (options_.response && !options_.start && options_.period == 1) trace_response();
    branches_.follow();
    if (options_.normal_forms) branches_.add_normal_forms();
    const double speed_scale = result_.scale.speed;
    result_.branches =
        put_in_order(branches_.take(), Components(highest_ - lowest_, speed_scale),
                     [this](const OrbitBranch& branch) { return connected_set(branch); });
    // The result of the simulation is reported only where it explains that there is nothing else.
    if (!result_.branches.empty() && !followed_) {
      result_.notes.clear();
      result_.details.clear();
    }
    // Reported only when something may be missing.
    if (options_.impacts == 1 && !options_.start && !followed_)
      (result_.sought.complete() ? result_.details : result_.notes)
          .push_back(in_words(result_.sought, family_.parameter(), options_.period));
    for (const std::string& note : branches_.notes()) result_.notes.push_back(note);
    result_.stopped = options_.stop.reason();
    return std::move(result_);
  }

 private:
  // Where closed forms are only starts for a search, their results come first, which cost next to
  // nothing, then simulations, which may never settle: if these are stopped, the branches of the
  // former are kept.
  void trace_from_search(int impacts) {
    FinderOptions all = options_.finder, quick = all, slow = all;
    quick.from_simulation = quick.from_random = false;
    slow.from_closed_form = false;
    const std::vector<FinderOptions> rounds =
        followed_ ? std::vector{quick, slow} : std::vector{all};
    for (std::size_t i = 0; i < rounds.size(); ++i)
      trace_from_values(rounds[i], impacts, static_cast<double>(i),
                        static_cast<double>(rounds.size()));
    if (options_.start_values > 0 && options_.finder.from_closed_form && options_.impacts == 1 &&
        !followed_)
      trace_from_surveys();
    result_.sought.stopped = options_.stop.requested();
  }

  // With friction orbits that meet no stop are found and followed like others.
  std::vector<int> wanted_impacts() const {
    std::vector<int> list;
    if (rubs_ && (options_.impacts == 0 || options_.response)) list.push_back(0);
    if (options_.impacts > 0) list.push_back(options_.impacts);
    return list;
  }

  // One trace reaches all of it unless undamped resonances, or values that are not allowed,
  // separate parts.
  void trace_response() {
    for (const double value : start_values()) branches_.trace_response(value);
  }

  std::vector<double> start_values() const {
    std::vector<double> values;
    if (family_.value() >= lowest_ && family_.value() <= highest_)
      values.push_back(family_.value());
    for (int i = 0; i < options_.start_values; ++i)
      values.push_back(lowest_ + (highest_ - lowest_) * i / std::max(options_.start_values - 1, 1));
    return values;
  }

  // Traces from the scene's own value, and values spread over the range; in one of several rounds.
  void trace_from_values(const FinderOptions& finder, int impacts, double round, double rounds) {
    const std::vector<double> values = start_values();
    result_.sought.start_values = static_cast<int>(values.size());
    if (options_.start_values > 1)
      result_.sought.start_spacing = (highest_ - lowest_) / (options_.start_values - 1);
    if (finder.from_random) result_.sought.random_starts = kStartsOfOneImpact;
    std::vector<std::optional<FoundOrbits>> found(values.size());
    for (std::size_t i = 0; i < values.size() && !options_.stop.requested(); ++i) {
      if (options_.progress)
        options_.progress(
            (round + static_cast<double>(i) / static_cast<double>(values.size() + 1)) / rounds);
      // The first value is searched alone, on all threads, since its search may take longer; then
      // some side by side. Results do not depend on their number.
      if (i == 0 || i % kValuesAtOnce == 1) {
        const std::size_t some = i == 0 ? 1 : std::min(kValuesAtOnce, values.size() - i);
        for_each_index(some, finder.threads, [&](std::size_t k) {
          FinderOptions one = finder;
          if (some > 1) one.threads = 1;
          if (!options_.stop.requested())
            found[i + k] = orbits_at(values[i + k], impacts, std::move(one), i + k == 0);
        });
      }
      for (const Orbit& orbit : taken(std::move(found[i])))
        if (!options_.stop.requested()) branches_.trace_from(orbit, values[i]);
      if (options_.sticking && finder.from_simulation && !followed_) trace_sticking(values[i]);
    }
  }

  void trace_from_surveys() {
    for (std::size_t stop = 0; stop < family_.scene().stops.size(); ++stop) {
      if (options_.stop.requested()) return;
      const int index = static_cast<int>(stop);
      if (!family_.at(family_.value())->stops[stop].restitution().is_constant()) {
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
        if (!branches_.trace_from({options_.period, {index}}, {start.point}, start.value))
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
      if (!branches_.trace_from({options_.period, {stop}}, {start.point}, start.value))
        ++result_.sought.lost;
    }
  }

  // Traces orbits on one stop and reports their branches.
  RunTracer run_tracer(int stop) {
    const ImpactPattern pattern{options_.period, {stop}};
    RunTracer tracer;
    tracer.trace = [this, pattern](const ImpactPoint& point, double value) {
      branches_.trace_from(pattern, {point}, value);
    };
    tracer.new_branches = [this, pattern, next = std::size_t{0}](const auto& hand_over) mutable {
      for (; next < branches_.found().size(); ++next) {
        const OrbitBranch& branch = branches_.found()[next].branch;
        if (branch.pattern == pattern) hand_over(branch);
      }
    };
    tracer.stopped = [this] { return options_.stop.requested(); };
    return tracer;
  }

  // Orbits at one value; random guesses, and on rigid stops the simulation for orbits of one
  // impact, are used at the first value only.
  std::optional<FoundOrbits> orbits_at(double value, int impacts, FinderOptions finder,
                                       bool first) const {
    const std::optional<Scene> scene = family_.scene_at(value);
    const std::optional<System> system = scene ? family_.system_of(*scene) : std::nullopt;
    if (!system) return {};
    finder.period = options_.period;
    finder.impacts = impacts;
    // With one impact, and with more than two, solutions are counted where they lie; with two all
    // orbits are found even if virtual solutions are not kept.
    finder.keep_virtual = !followed_ && (options_.keep_virtual || options_.impacts != 2);
    finder.sticking = options_.sticking;
    finder.stop = options_.stop;
    // Random guesses cost more than all else; at other values they replace a missing closed form.
    if (!first && (followed_ ||
                   (options_.impacts == 1 && finder.from_closed_form && has_closed_forms(*system))))
      finder.from_random = false;
    std::optional<State> start;
    if (first || options_.impacts > 1 || followed_) start = clear_start(*scene, *system);
    finder.closure_speed = closure_speed_;
    return find_orbits(*system, start, finder);
  }

  // The orbits to start from; the finder's notes are passed on.
  std::vector<Orbit> taken(std::optional<FoundOrbits> found) {
    if (!found) return {};
    // On rigid stops alone orbits that stick have a search of their own.
    if (!followed_) std::erase_if(found->orbits, [](const Orbit& orbit) { return orbit.sticks(); });
    if (result_.notes.empty()) {
      result_.notes = std::move(found->notes);
      result_.details = std::move(found->details);
    }
    if (!followed_) {
      result_.starts += found->inadmissible;
      result_.virtual_starts += found->inadmissible;
    }
    return std::move(found->orbits);
  }

  // Whether the closed form holds at every stop.
  bool has_closed_forms(const System& system) const {
    for (std::size_t stop = 0; stop < system.stops.size(); ++stop)
      if (!closed_form(system, static_cast<int>(stop), options_.period).form) return false;
    return true;
  }

  void trace_from_settled() {
    for (const SettledStart& start : options_.settled)
      if (!options_.stop.requested())
        trace_settled(start.value, start.state, Wanted::kAny, start.period);
    result_.cut_settled = result_.cut_short;
  }

  // Traces the branch of the orbit that sticks, where the motion from the scene's initial state
  // settles on one.
  void trace_sticking(double value) {
    const std::optional<Scene> scene = family_.scene_at(value);
    const std::optional<System> system = scene ? family_.system_of(*scene) : std::nullopt;
    if (!system) return;
    if (const std::optional<State> start = clear_start(*scene, *system))
      trace_settled(value, *start, Wanted::kSticking);
  }

  enum class Wanted {
    kAny,
    kSticking  // with the period that is sought
  };
  // Traces the branch of the orbit that the motion from a state settles on, if it is wanted.
  void trace_settled(double value, const State& start, Wanted wanted, int period = 0) {
    const std::optional<System> system = family_.at(value);
    if (!system) return;
    SettleOptions settling;
    settling.periods = kPeriodsToStick;
    settling.repeats_after = period;
    settling.max_impacts = options_.finder.max_impacts;
    settling.closure_speed = closure_speed_;
    settling.stop = options_.stop;
    const SettledMotion settled = settle(*system, start, settling);
    const bool any = wanted == Wanted::kAny;
    if (period > 0 && settled.kind == SettledKind::kClear) return branches_.trace_response(value);
    if (settled.kind != SettledKind::kSticks && !(any && settled.kind == SettledKind::kImpacts))
      return;
    const std::optional<Orbit> orbit =
        orbit_near(*system, settled, {closure_speed_, settling.max_impacts, options_.stop}).orbit;
    if (orbit && (any || orbit->period == options_.period)) branches_.trace_from(*orbit, value);
    if (!orbit && period > 0)
      result_.notes.push_back("near the state no orbit closes after that many forcing periods");
  }

  // Branches that were traced separately may be connected by virtual solutions; the closed form
  // shows that.
  std::optional<std::pair<int, int>> connected_set(const OrbitBranch& branch) const {
    if (branch.pattern.stops.empty()) return {};
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
  bool followed_ = false;       // orbits are, and not solved by their impacts
  bool rubs_ = false;           // there are orbits without impacts to be found
  double closure_speed_ = 0.0;  // m/s; as asked for, or by the scene's tolerance
  OrbitBranches result_;
  BranchCollector branches_;
  std::map<int, ClosedFormSurvey> surveys_;  // by stop
};

}  // namespace

OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options) {
  return trace_orbits(family, options, OrbitNumber());
}

OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options,
                           const OrbitNumber& shown) {
  if (const auto fault = fault_in(options)) throw InputError(fault->text());
  return OrbitTracer(family, options, shown).trace();
}

}  // namespace graze
