#include "graze/orbit/search/finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "graze/base/parallel.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/closed_form/detail/periodic_response.hpp"
#include "graze/orbit/closed_form/response.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/detail/contact_starts.hpp"
#include "graze/orbit/search/detail/impact_sequences.hpp"
#include "graze/orbit/search/detail/mirror.hpp"
#include "graze/orbit/search/detail/pair_search.hpp"
#include "graze/orbit/search/detail/phase_search.hpp"
#include "graze/orbit/search/detail/rough_guess.hpp"
#include "graze/orbit/search/detail/self_excited.hpp"
#include "graze/orbit/search/detail/solved_orbit.hpp"
#include "graze/orbit/search/settled.hpp"

namespace graze {
namespace {

// A search without a given k adds patterns of 2 and 3 impacts to (p, 1) while one evaluation of all
// their phase problems takes no more products than this (k^2 N for each sequence of stops; 512 of
// them cost some ten microseconds, a search a few thousand evaluations).
constexpr int kCheapWork = 512;

constexpr std::size_t kMostSequences = 4096;  // of stops that are searched, whatever k

// Boost's table for Sobol sequences reaches further; a dense solve for more is out of the question.
constexpr int kMostImpacts = 1024;

constexpr int kGlobalRuns = 4;  // for a pattern for which local solves find no orbit

// Budgets of the local solves by the number of impacts: see
// docs/decisions/0053.
PhaseSearchOptions search_budget(int impacts, bool explicitly) {
  PhaseSearchOptions budget;
  budget.starts = impacts == 1 ? kStartsOfOneImpact : impacts == 2 ? 64 : 128;
  budget.rounds = impacts == 1 ? 2 : explicitly ? 16 : 4;
  budget.global_evaluations = 1024 * impacts;
  return budget;
}

class Finder {
 public:
  Finder(const System& system, const std::optional<State>& start, const FinderOptions& options)
      : system_(system),
        start_(start),
        options_(options),
        scale_(motion_scale(system)),
        followed_(!system.has_modal_flights()) {
    const State at_rest{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
    segment_options_.closure_speed =
        options.closure_speed.value_or(default_closure_speed(system, start.value_or(at_rest)));
    segment_options_.max_impacts = options.max_impacts;
    segment_options_.stop = options.stop;
  }

  FoundOrbits find() {
    if (system_.is_self_excited()) {
      if (start_)
        keep(self_excited_orbit(system_, *start_, segment_options_, found_.notes),
             found_.simulation);
      return conclude();
    }
    const bool one_impact = !options_.impacts || *options_.impacts == 1;
    if (options_.from_closed_form && one_impact)
      followed_ ? from_closed_form_contacts() : from_closed_form();
    if (options_.from_simulation && start_) from_simulation();
    if (const auto response = options_.impacts == 0 ? response_of(system_) : std::nullopt)
      keep(response_orbit(system_, *response));
    if (!followed_ && options_.impacts != 0)
      from_phases();
    else if (options_.from_random)
      from_rough_contacts();
    add_mirror_images();
    return conclude();
  }

 private:
  void from_closed_form() {
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const ClosedFormAnswer answer = closed_form(system_, static_cast<int>(i), options_.period);
      if (!answer.form) {
        found_.notes.push_back("the closed form does not hold: " + answer.why_not);
        continue;
      }
      const ShootingProblem problem({options_.period, {static_cast<int>(i)}}, scale_);
      for (const ImpactPoint& point : answer.form->solutions(system_.stops[i].gap)) {
        if (options_.stop.requested()) return;
        keep(problem, newton(problem, system_, problem.pack(system_, {point})), found_.closed_form);
      }
    }
  }

  void from_simulation() {
    found_.simulated = true;
    SettleOptions settle_options;
    settle_options.max_impacts = options_.max_impacts;
    settle_options.stop = options_.stop;
    settle_options.closure_speed = options_.closure_speed;
    const SettledMotion settled = settle(system_, *start_, settle_options);
    const bool sticks = settled.kind == SettledKind::kSticks;
    const bool rubs = settled.kind == SettledKind::kClear && !system_.frictions.empty();
    if (!sticks && !rubs && settled.kind != SettledKind::kImpacts) {
      found_.notes.push_back(settled.classification);
      return;
    }
    const FollowedAnswer answer =
        keep(orbit_near(system_, settled, segment_options_), found_.simulation);
    if (!answer.orbit) {
      found_.notes.push_back(settled.classification + (sticks ? "; " : ", but ") + answer.why_not);
      return;
    }
    const Orbit& orbit = *answer.orbit;
    if (!orbit.sticks()) {
      found_.notes.push_back(
          fmt::format("from the scene's initial state the motion settles on a ({}, {}) orbit",
                      orbit.period, orbit.impacts.size()));
      return;
    }
    found_.notes.push_back(fmt::format("{}; solved for, it is a ({}, {}) orbit that sticks",
                                       settled.classification, orbit.period, orbit.impacts.size()));
    found_.details.push_back(fmt::format("the closure speed of its chatters is {:.4g}{}",
                                         segment_options_.closure_speed,
                                         unit_behind(system_.units, "m/s")));
  }

  // Keeps the orbit that a start led to, if it is one asked for.
  FollowedAnswer keep(FollowedAnswer answer, StartCount& count) {
    ++count.tried;
    if (!answer.orbit) return answer;
    ++count.converged;
    const Orbit& orbit = *answer.orbit;
    const bool any_number = options_.sticking && orbit.sticks();
    if (any_number ? orbit.period == options_.period
                   : options_.asks_for(orbit.period, orbit.impacts.size()))
      keep(orbit);
    return answer;
  }

  void from_closed_form_contacts() {
    for (const State& start : closed_form_contacts(system_, options_.period, segment_options_))
      if (!options_.stop.requested())
        keep(followed_orbit(system_, start, options_.period, segment_options_), found_.closed_form);
  }

  void from_rough_contacts() {
    // A map with its derivatives costs as N^3.
    const int modes = system_.modes();
    const int guesses = std::min(options_.random_guesses, std::max(4, 64 / (modes * modes)));
    for (int stop = 0; stop < static_cast<int>(system_.stops.size()); ++stop) {
      ++found_.patterns;
      for (const State& start :
           rough_contacts(system_, stop, options_.period, guesses, speed_scale(),
                          options_.random_seed, segment_options_)) {
        if (options_.stop.requested()) return;
        keep(followed_orbit(system_, start, options_.period, segment_options_), found_.random);
      }
    }
  }

  // Orbits by the phases of their impacts: of two impacts in closed form, others by a search.
  void from_phases() {
    const bool two = options_.from_closed_form && options_.impacts.value_or(2) == 2;
    if (!two && !options_.from_random) return;
    const bool too_many = options_.impacts && *options_.impacts > kMostImpacts;
    if (too_many)
      found_.notes.push_back(fmt::format(
          "no random starts: quasi-random phases are for up to {} impacts", kMostImpacts));
    if (too_many) return;
    const PeriodicResponseAnswer answer = periodic_response(system_, options_.period);
    if (!answer.response && options_.from_random)
      found_.notes.push_back("impacts are not sought by their phases alone: " + answer.why_not);
    std::vector<std::vector<int>> rest = sequences();
    if (answer.response && two) from_two_impacts(*answer.response, rest);
    if (!options_.from_random) return;
    for (const std::vector<int>& stops : rest) {
      if (options_.stop.requested()) return;
      ++found_.patterns;
      const ImpactPattern pattern{options_.period, stops};
      if (answer.response)
        search_phases(*answer.response, pattern);
      else
        from_rough_guesses(pattern);
    }
  }

  // Solves the sequences of two impacts to which the closed form applies, and removes them from the
  // list.
  void from_two_impacts(const PeriodicResponse& response, std::vector<std::vector<int>>& list) {
    const auto is_pair = [](const std::vector<int>& stops) { return stops.size() == 2; };
    const auto first = std::find_if(list.begin(), list.end(), is_pair);
    if (first == list.end()) return;
    const TwoImpactsAnswer answer = two_impacts(response);
    if (!answer.form) {
      found_.details.push_back("two impacts are not sought in closed form: " + answer.why_not);
      return;
    }
    const auto last = std::stable_partition(first, list.end(), [&](const auto& stops) {
      return is_pair(stops) && answer.form->holds(stops[0], stops[1]);
    });
    const std::vector<std::vector<int>> pairs(first, last);
    list.erase(first, last);
    if (std::any_of(list.begin(), list.end(), is_pair))
      (options_.from_random ? found_.details : found_.notes)
          .push_back(
              "the closed form of two impacts does not hold on every pair of stops: restitution "
              "depends on the speed there, or nothing is lost");
    const PhaseJudge judge(system_, response, scale_, options_.keep_virtual);
    const PairSolutions solved =
        solve_pairs(*answer.form, response, judge, pairs, scale_, options_.threads, options_.stop);
    found_.pairs = static_cast<int>(pairs.size());
    found_.two_impacts = {solved.tried, solved.converged};
    found_.inadmissible += solved.refused;
    keep(judge, solved.solutions);
  }

  std::vector<std::vector<int>> sequences() {
    const int stops = static_cast<int>(system_.stops.size());
    std::vector<std::vector<int>> all;
    const int least = options_.impacts.value_or(1), most = options_.impacts.value_or(3);
    for (int k = least; k <= most; ++k) {
      ImpactSequences part = impact_sequences(stops, k, kMostSequences);
      const int work = static_cast<int>(part.sequences.size()) * k * k * system_.modes();
      if (k > 1 && !options_.impacts && work > kCheapWork) break;
      if (!part.complete)
        found_.notes.push_back(
            fmt::format("only the first {} sequences of {} impacts were searched, of the {} "
                        "stops there are more",
                        kMostSequences, k, stops));
      std::move(part.sequences.begin(), part.sequences.end(), std::back_inserter(all));
    }
    return all;
  }

  void search_phases(const PeriodicResponse& response, const ImpactPattern& pattern) {
    PhaseSearchOptions budget = search_budget(pattern.impacts(), options_.impacts.has_value());
    budget.approaching = !options_.keep_virtual;
    budget.seed = options_.random_seed;
    budget.length = scale_.length;
    budget.speed = speed_scale();
    budget.threads = options_.threads;
    budget.stop = options_.stop;
    PhaseSearch search(response, pattern, budget);
    // For one impact the closed form and the search are to confirm each other.
    if (pattern.impacts() > 1)
      for (const Orbit& orbit : found_.orbits)
        if (orbit.period == pattern.period && orbit.pattern().impacts() == pattern.impacts())
          search.know(orbit.pattern().stops, turned_phases(orbit));
    const PhaseJudge judge(system_, response, scale_, options_.keep_virtual);
    bool any = keep(judge, search.local());
    found_.random.tried += search.tried();
    found_.random.converged += search.converged();
    for (int run = 0; run < kGlobalRuns && !any && !options_.stop.requested(); ++run) {
      ++found_.global.tried;
      const std::optional<PhaseSolution> solution = search.global();
      if (!solution) continue;
      ++found_.global.converged;
      any = keep(judge, {*solution});
    }
  }

  static Vector turned_phases(const Orbit& orbit) {
    Vector phases(static_cast<Eigen::Index>(orbit.impacts.size()));
    Eigen::Index i = 0;
    for (const ImpactPoint& point : orbit.points()) phases[i++] = point.theta;
    return phases;
  }

  // Keeps the solutions that are orbits (or may be listed); returns whether there was one.
  bool keep(const PhaseJudge& judge, const std::vector<PhaseSolution>& solutions) {
    std::vector<std::optional<Orbit>> orbits(solutions.size());
    for_each_index(solutions.size(), options_.threads, [&](std::size_t i) {
      if (!options_.stop.requested()) orbits[i] = judge.orbit_of(solutions[i]);
    });
    bool any = false;
    for (const std::optional<Orbit>& orbit : orbits) {
      if (!orbit) continue;
      any = any || orbit->admissible || options_.keep_virtual;
      keep(*orbit);
    }
    return any;
  }

  void from_rough_guesses(const ImpactPattern& pattern) {
    // A least-squares solve grows as the cube of its unknowns: many modes get fewer guesses.
    const int guesses =
        std::min(options_.random_guesses, std::max(4, 128 / (system_.modes() * pattern.impacts())));
    const ShootingProblem problem(pattern, scale_);
    std::vector<Vector> from;
    for (const std::vector<ImpactPoint>& points :
         rough_guesses(system_, pattern, guesses, speed_scale(), options_.random_seed))
      from.push_back(problem.pack(system_, points));
    std::vector<std::optional<ShootingSolution>> solutions(from.size());
    for_each_index(from.size(), options_.threads, [&](std::size_t i) {
      if (!options_.stop.requested()) solutions[i] = seek(problem, system_, from[i]);
    });
    for (const std::optional<ShootingSolution>& solution : solutions) {
      const std::optional<Orbit> orbit = judge(problem, solution, found_.random);
      if (orbit && orbit->period == pattern.period &&
          orbit->pattern().impacts() == pattern.impacts())
        keep(*orbit);
    }
  }

  std::optional<Orbit> judge(const ShootingProblem& problem,
                             const std::optional<ShootingSolution>& solution, StartCount& count) {
    ++count.tried;
    if (!solution) return {};
    ++count.converged;
    return minimal_orbit(system_, problem, *solution);
  }

  void keep(const ShootingProblem& problem, const std::optional<ShootingSolution>& solution,
            StartCount& count) {
    if (const std::optional<Orbit> orbit = judge(problem, solution, count)) keep(*orbit);
  }

  void keep(const Orbit& orbit) {
    if (!orbit.in_order()) return;
    for (Orbit& known : found_.orbits)
      if (same_orbit(known, orbit, speed_scale())) {
        if (orbit.residual < known.residual) known = orbit;
        return;
      }
    found_.orbits.push_back(orbit);
  }

  // Between mirrored stops orbits come in pairs: whichever of two was found, both are listed.
  void add_mirror_images() {
    const std::optional<std::vector<int>> opposite = opposite_stops(system_);
    if (!opposite) return;
    for (const Orbit& orbit : std::vector<Orbit>(found_.orbits)) {
      if (!(orbit.admissible || options_.keep_virtual)) continue;
      if (const auto image = mirrored_orbit(system_, orbit, *opposite, segment_options_))
        keep(*image);
    }
  }

  FoundOrbits conclude() {
    std::vector<Orbit>& orbits = found_.orbits;
    if (!options_.keep_virtual) {
      const auto is_virtual = [](const Orbit& orbit) { return !orbit.admissible; };
      found_.inadmissible +=
          static_cast<int>(std::count_if(orbits.begin(), orbits.end(), is_virtual));
      orbits.erase(std::remove_if(orbits.begin(), orbits.end(), is_virtual), orbits.end());
    }
    std::sort(orbits.begin(), orbits.end(), comes_before);
    found_.tried = what_was_tried();
    return std::move(found_);
  }

  std::string what_was_tried() const {
    if (followed_)
      return fmt::format("{} rigid orbits, {} simulation, {} rough guesses",
                         found_.closed_form.tried, found_.simulated ? "the" : "no",
                         found_.random.tried);
    std::vector<std::string> parts;
    if (found_.closed_form.tried > 0)
      parts.push_back(fmt::format("{} solutions of the closed form", found_.closed_form.tried));
    if (found_.simulated) parts.push_back("the simulation");
    if (found_.pairs > 0)
      parts.push_back(
          fmt::format("{} starts from the closed form of two impacts on {} pair{} of stops",
                      found_.two_impacts.tried, found_.pairs, found_.pairs == 1 ? "" : "s"));
    if (found_.patterns > 0)
      parts.push_back(fmt::format("{} random starts on {} sequence{} of stops", found_.random.tried,
                                  found_.patterns, found_.patterns == 1 ? "" : "s"));
    if (found_.global.tried > 0)
      parts.push_back(fmt::format("{} global minimisations", found_.global.tried));
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  double speed_scale() const { return scale_.speed; }

  const System& system_;
  const std::optional<State>& start_;
  const FinderOptions& options_;
  MotionScale scale_;
  bool followed_;  // every orbit is
  SegmentOptions segment_options_;
  FoundOrbits found_;
};

}  // namespace

FoundOrbits find_orbits(const System& system, const std::optional<State>& start,
                        const FinderOptions& options) {
  return Finder(system, start, options).find();
}

}  // namespace graze
