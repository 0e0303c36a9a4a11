#include "graze/study/plane/attractor_search.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/closed_form/detail/periodic_response.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/detail/random_start.hpp"
#include "graze/orbit/search/detail/solved_orbit.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/study/sweep/detail/followed_motion.hpp"
#include "graze/study/sweep/detail/stroboscopic_states.hpp"

namespace graze {
namespace {

// Distance from its orbit of a motion that is to settle on it, relative to the nearness, in units
// of the scale. A repelling orbit never lets it come nearer by this factor, and only basins too
// narrow to matter are smaller.
constexpr double kHasToShrink = 100.0;

// Factor by which a transient shrinks within the periods of a motion.
constexpr double kForgets = 100.0;
// Largest factor on the periods for the sake of slowly decaying modes.
constexpr double kMostForSlowModes = 4.0;

// The requested periods, or those in which the least damped mode decays.
long long periods_to_forget(const System& system, const AttractorSearchOptions& options) {
  const double asked = static_cast<double>(options.periods);
  const double slow = std::log(kForgets) / (system.delta().minCoeff() * system.period());
  return static_cast<long long>(std::min(asked + slow, kMostForSlowModes * asked));
}

class AttractorSearch {
 public:
  AttractorSearch(const System& system, const AttractorSearchOptions& options,
                  PlaceAttractors known)
      : system_(system),
        options_(options),
        followed_(!system.has_modal_flights()),
        scale_(motion_scale(system)),
        periods_(periods_to_forget(system, options)),
        found_(std::move(known)) {}

  PlaceAttractors find(const std::optional<State>& initial) {
    if (options_.from_closed_form && options_.impacts == 1) from_closed_form();
    from_steady_response();
    if (options_.from_simulation && initial) settle_from(*initial, "the scene's initial state");
    for (int i = 0; i < options_.random_starts && found_.finished; ++i)
      settle_from(random_start(system_, options_.random_seed,
                               options_.first_draw + static_cast<std::uint64_t>(i)),
                  "a random start");
    return std::move(found_);
  }

  PlaceAttractors take_over(const std::vector<const Attractor*>& from) {
    for (const Attractor* attractor : from)
      if (found_.finished) take_over(*attractor);
    return std::move(found_);
  }

 private:
  void from_closed_form() {
    for (std::size_t i = 0; i < system_.stops.size(); ++i)
      found_.searched += holds_closed_form(static_cast<int>(i)) ? 1 : 0;
    if (found_.searched == 0 && !followed_) return;
    FinderOptions finder;
    finder.period = options_.period;
    finder.impacts = 1;
    finder.from_simulation = finder.from_random = false;
    finder.threads = 1;
    for (const Orbit& orbit : find_orbits(system_, std::nullopt, finder).orbits)
      if (found_.finished && orbit.stable == true && !knows(orbit)) check(orbit);
  }

  // On compliant stops the closed form only gives starts, and not the number of orbits.
  bool holds_closed_form(int stop) const {
    return !followed_ && closed_form(system_, stop, options_.period).form.has_value();
  }

  // Whether the closed form should have had this orbit.
  bool is_searched(const Orbit& orbit) const {
    return options_.from_closed_form && options_.impacts == 1 && orbit.period == options_.period &&
           orbit.impacts.size() == 1 && holds_closed_form(orbit.impacts.front().stop);
  }

  // A response that meets no stop is stable: motions near it are linear. Without damping they stay
  // near.
  void from_steady_response() {
    const PeriodicResponseAnswer answer = periodic_response(system_, 1);
    if (!answer.response) return;
    const State steady = answer.response->forced_state(system_.forcing()->phase);
    if (!is_clear(system_, steady)) return;
    const SettledMotion motion = follow(steady, "the steady response", periods_);
    if (motion.kind == SettledKind::kClear) add({{AttractorKind::kClear, 0, 0}, {}, steady});
  }

  void take_over(const Attractor& from) {
    if (from.name.kind != AttractorKind::kOrbit) {
      if (!knows(from.name.kind)) settle_from(from.start, "a neighbour's state");
      return;
    }
    if (!solve_for(*from.orbit)) settle_from(from.start, "a neighbour's state");
  }

  // Whether a neighbour's orbit exists here as a stable one.
  bool solve_for(const Orbit& neighbour) {
    const auto is_like = [&](const Attractor& known) {
      return known.orbit && known.orbit->pattern().stops == neighbour.pattern().stops &&
             known.orbit->period == neighbour.period;
    };
    if (is_searched(neighbour)) return std::any_of(found_.list.begin(), found_.list.end(), is_like);
    const std::optional<Orbit> orbit = orbit_near(system_, neighbour, segment_options());
    if (!orbit || orbit->stable != true || !orbit->admissible) return false;
    if (knows(*orbit)) return true;
    if (is_searched(*orbit)) found_.missed.push_back(*orbit);
    check(*orbit);
    return true;
  }

  // The orbit that a repeating motion has settled on.
  std::optional<Orbit> solve(const SettledMotion& motion) const {
    return orbit_near(system_, motion, segment_options()).orbit;
  }

  SegmentOptions segment_options() const {
    return {options_.closure_speed, options_.max_impacts, options_.stop};
  }

  // Lists a stable orbit if the motion beside it settles on it.
  void check(const Orbit& orbit) {
    const MotionName name{AttractorKind::kOrbit, orbit.period,
                          static_cast<int>(orbit.impacts.size())};
    const State start = stroboscopic_states(system_, orbit).front();
    State beside = start;
    const double part = kHasToShrink * options_.nearness;
    beside.q.array() += part * scale_.displacement;
    beside.qdot += part * scale_.velocity;
    // A start beyond a stop, beside an orbit that passes near it, is moved to the free side.
    if (!bring_clear(system_, beside)) beside = start;
    const SettledMotion motion = follow(beside, "beside an orbit", periods_to_shrink(orbit));
    if (!found_.finished) return;
    if (!is_on(motion, orbit)) {
      found_.refuted.push_back(orbit);
      return;
    }
    ++(motion.near ? found_.confirmed : found_.undecided);
    add({name, orbit, start});
  }

  // Forcing periods in which the largest multiplier shrinks a deviation by the required factor, and
  // as many again because a matrix may grow before its powers shrink.
  long long periods_to_shrink(const Orbit& orbit) const {
    const double largest = orbit.multipliers.empty() ? 0.0 : std::abs(orbit.multipliers[0].value);
    const double turns = largest > 0.0 ? 2.0 * std::log(kHasToShrink) / -std::log(largest) : 0.0;
    const double periods = static_cast<double>(periods_) + orbit.period * turns;
    const auto most = static_cast<double>(options_.most_periods);
    return periods < most ? static_cast<long long>(periods) : options_.most_periods;
  }

  bool is_on(const SettledMotion& motion, const Orbit& orbit) const {
    if (motion.kind != SettledKind::kImpacts) return false;
    const std::optional<Orbit> settled = solve(motion);
    return settled && is_same(*settled, orbit);
  }

  void settle_from(State start, const char* what) {
    if (!bring_clear(system_, start)) return;
    const SettledMotion motion = follow(start, what, periods_);
    if (!found_.finished) return;
    const AttractorKind kind = kind_of(motion);
    if (kind == AttractorKind::kOrbit) {
      const std::optional<Orbit> orbit = solve(motion);
      if (orbit && orbit->stable != false) return add_settled(*orbit, motion.at_start);
    }
    if (motion.kind == SettledKind::kImpactBudget || motion.kind == SettledKind::kRefused) {
      found_.message = motion.classification;
      return;
    }
    const AttractorKind listed = kind == AttractorKind::kOrbit ? AttractorKind::kOther : kind;
    if (!knows(listed)) add({{listed, 0, 0}, {}, motion.at_end});
  }

  void add_settled(const Orbit& orbit, const State& start) {
    if (knows(orbit)) return;
    if (is_searched(orbit)) found_.missed.push_back(orbit);
    add({{AttractorKind::kOrbit, orbit.period, static_cast<int>(orbit.impacts.size())},
         orbit,
         start});
  }

  AttractorKind kind_of(const SettledMotion& motion) const {
    switch (motion.kind) {
      case SettledKind::kImpacts:
        return motion.period <= 2 * options_.period &&
                       static_cast<int>(motion.impacts.size()) <= 2 * options_.impacts
                   ? AttractorKind::kOrbit
                   : AttractorKind::kOther;
      case SettledKind::kSticks:
        return AttractorKind::kSticks;
      case SettledKind::kAtRest:
        return AttractorKind::kAtRest;
      case SettledKind::kClear:
        return AttractorKind::kClear;
      default:
        // Clear of the stops for all recorded periods: on its way to the steady response, or
        // oscillating beside it without end.
        return motion.impacts.empty() && !motion.sticks ? AttractorKind::kClear
                                                        : AttractorKind::kOther;
    }
  }

  SettledMotion follow(const State& start, const char* from, long long periods) {
    SettleOptions settling;
    settling.periods = periods;
    settling.max_impacts = options_.max_impacts;
    settling.closure_speed = options_.closure_speed;
    settling.nearness = options_.nearness;
    settling.from = from;
    settling.stop = options_.stop;
    ++found_.simulated;
    SettledMotion motion =
        follow_while_nearing(system_, start, settling, 2 * options_.period, options_.most_periods);
    if (motion.kind == SettledKind::kInterrupted || motion.kind == SettledKind::kTimeBudget)
      found_.finished = false;
    return motion;
  }

  void add(Attractor attractor) { found_.list.push_back(std::move(attractor)); }

  bool knows(AttractorKind kind) const {
    return std::any_of(found_.list.begin(), found_.list.end(),
                       [&](const Attractor& known) { return known.name.kind == kind; });
  }
  bool knows(const Orbit& orbit) const {
    return std::any_of(found_.list.begin(), found_.list.end(),
                       [&](const Attractor& known) {
                         return known.orbit && is_same(*known.orbit, orbit);
                       }) ||
           std::any_of(found_.refuted.begin(), found_.refuted.end(),
                       [&](const Orbit& refuted) { return is_same(refuted, orbit); });
  }
  bool is_same(const Orbit& a, const Orbit& b) const { return same_orbit(a, b, scale_.speed); }

  const System& system_;
  const AttractorSearchOptions& options_;
  bool followed_;  // orbits are, and not solved by their impacts
  MotionScale scale_;
  long long periods_;  // a motion is followed at first
  PlaceAttractors found_;
};

}  // namespace

std::string name_of(const MotionName& name) {
  switch (name.kind) {
    case AttractorKind::kOrbit:
      return fmt::format("({},{})", name.period, name.impacts);
    case AttractorKind::kClear:
      return "no impact";
    case AttractorKind::kSticks:
      return "sticks";
    case AttractorKind::kAtRest:
      return "at rest";
    case AttractorKind::kOther:
      break;
  }
  return "other";
}

PlaceAttractors find_attractors(const System& system, const std::optional<State>& initial,
                                const AttractorSearchOptions& options) {
  return AttractorSearch(system, options, {}).find(initial);
}

PlaceAttractors hand_on(const System& system, PlaceAttractors known,
                        const std::vector<const Attractor*>& from,
                        const AttractorSearchOptions& options) {
  return AttractorSearch(system, options, std::move(known)).take_over(from);
}

}  // namespace graze
