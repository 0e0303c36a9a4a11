#include "graze/orbit/search/spread_starts.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/parallel.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/orbit_identity.hpp"
#include "graze/orbit/search/detail/random_start.hpp"
#include "graze/orbit/search/detail/solved_orbit.hpp"
#include "graze/orbit/search/settled.hpp"

namespace graze {
namespace {

// A stable orbit this near, in rad and units of the forced motion's speed, attracts a motion;
// settled.cpp uses the same distance for being on the way elsewhere.
constexpr double kNearStart = 1e-3;
// Boost's table of Sobol sequences ends there; each stop needs two dimensions.
constexpr std::size_t kMostStops = 1833;
// Motions that are followed side by side, with the same known orbits.
constexpr std::size_t kRound = 16;
// Forcing periods until a motion is first compared with the known orbits; then twice as many.
constexpr long long kFirstLook = 16;
constexpr long long kMostPeriods = 1024;

enum class Fate { kKnown, kSettled, kClear, kOther };

struct Followed {
  Fate fate = Fate::kOther;
  std::size_t known = 0;  // index of the orbit
  SettledMotion motion;
  long long work = 0;
};

class Spread {
 public:
  Spread(const System& system, const FinderOptions& options, long long most_work,
         FoundOrbits& found)
      : system_(system),
        options_(options),
        most_work_(most_work),
        found_(found),
        scale_(motion_scale(system)),
        numbers_(2 * places_of_starts(system)) {
    std::mt19937_64 engine(options.random_seed);
    for (std::size_t i = 0; i < 2 * places_of_starts(system); ++i) shift_.push_back(engine());
    for (const Orbit& orbit : found.orbits)
      if (orbit.stable == true && orbit.admissible) known_.push_back(orbit);
  }

  void follow() {
    std::size_t left = kSpreadStarts;
    long long work = 0;
    while (left > 0 && work < most_work_ && !options_.stop.requested()) {
      std::vector<State> starts;
      for (; left > 0 && starts.size() < kRound; --left) starts.push_back(next_start());
      std::vector<Followed> ends(starts.size());
      for_each_index(starts.size(), options_.threads,
                     [&](std::size_t i) { ends[i] = followed(starts[i]); });
      for (const Followed& end : ends) {
        work += end.work;
        take(end);
      }
    }
    if (any_new_) conclude();
  }

 private:
  double speed_scale() const { return scale_.speed; }

  // In [-1, 1); bits by hand: results shall not depend on a library's distributions.
  double coordinate(std::size_t i) {
    return static_cast<double>((numbers_() ^ shift_[i]) >> 11) * 0x1p-52 - 1.0;
  }

  State next_start() {
    std::vector<double> coordinates(shift_.size());
    for (std::size_t i = 0; i < coordinates.size(); ++i) coordinates[i] = coordinate(i);
    return start_at(system_, coordinates);
  }

  Followed followed(const State& start) const {
    Followed result;
    State at = start;
    if (!is_clear(system_, at)) return result;  // stops that act on one another
    const long long share = std::max(most_work_ / static_cast<long long>(kRound), kFirstLook);
    for (long long periods = kFirstLook; periods <= kMostPeriods; periods *= 2) {
      SettleOptions settling;
      settling.periods = periods;
      settling.tail = settling.longest_period;
      settling.max_impacts = std::min(options_.max_impacts, share);
      settling.closure_speed = options_.closure_speed;
      settling.stop = options_.stop;
      result.motion = settle(system_, at, settling);
      result.work += result.motion.periods + result.motion.impacts_met;
      const bool clear = result.motion.kind == SettledKind::kClear;
      if (clear) result.fate = Fate::kClear;
      // With friction a motion that is clear of stops is an orbit to be solved for.
      if (result.motion.kind == SettledKind::kImpacts || (clear && !system_.frictions.empty()))
        result.fate = Fate::kSettled;
      for (std::size_t i = 0; i < known_.size() && result.fate != Fate::kClear; ++i)
        if (is_near(known_[i], result.motion.impacts)) {
          result.fate = Fate::kKnown;
          result.known = i;
        }
      if (result.fate != Fate::kOther || result.motion.kind != SettledKind::kNotPeriodic ||
          result.work >= share || options_.stop.requested())
        break;
      at = result.motion.at_end;
    }
    return result;
  }

  // Whether the last round of these impacts is that of an orbit, starting at any of its impacts.
  bool is_near(const Orbit& orbit, const std::vector<MetImpact>& met) const {
    const std::size_t k = orbit.impacts.size();
    if (k == 0 || met.size() < k) return false;
    const auto angle = [](long long period, double phase) {
      return kTurn * static_cast<double>(period) + phase;
    };
    for (std::size_t shift = 0; shift < k; ++shift) {
      bool near = true;
      const OrbitImpact& origin = orbit.impacts[shift];
      const MetImpact& first = met[met.size() - k];
      near = std::abs(std::remainder(first.phase - origin.phase, kTurn)) < kNearStart;
      for (std::size_t i = 0; i < k && near; ++i) {
        const OrbitImpact& impact = orbit.impacts[(shift + i) % k];
        const MetImpact& its = met[met.size() - k + i];
        const int round = shift + i < k ? 0 : orbit.period;
        const double along = angle(impact.period_index + round, impact.phase) -
                             angle(origin.period_index, origin.phase);
        const double flown = angle(its.period, its.phase) - angle(first.period, first.phase);
        near = impact.stop == its.stop && std::abs(along - flown) < kNearStart &&
               std::abs(impact.speed - its.speed) < kNearStart * speed_scale();
      }
      if (near) return true;
    }
    return false;
  }

  std::optional<Orbit> solved(const SettledMotion& motion) const {
    const double closure_speed =
        options_.closure_speed.value_or(default_closure_speed(system_, motion.at_start));
    return orbit_near(system_, motion, {closure_speed, options_.max_impacts, options_.stop}).orbit;
  }

  void take(const Followed& end) {
    ++followed_;
    if (end.fate == Fate::kKnown) ++settled_[name_of(known_[end.known])];
    if (end.fate == Fate::kClear) ++clear_;
    if (end.fate != Fate::kSettled) return;
    const std::optional<Orbit> orbit = solved(end.motion);
    if (!orbit || !orbit->admissible) return;
    ++settled_[name_of(*orbit)];
    const auto is_same = [&](const Orbit& other) {
      return same_orbit(other, *orbit, speed_scale());
    };
    if (std::any_of(known_.begin(), known_.end(), is_same)) return;
    if (orbit->stable == true) known_.push_back(*orbit);
    if (!options_.asks_for(orbit->period, orbit->impacts.size())) return;
    if (std::any_of(found_.orbits.begin(), found_.orbits.end(), is_same)) return;
    any_new_ = true;
    found_.orbits.push_back(*orbit);
  }

  static std::pair<int, int> name_of(const Orbit& orbit) {
    return {orbit.period, static_cast<int>(orbit.impacts.size())};
  }

  void conclude() {
    std::sort(found_.orbits.begin(), found_.orbits.end(), comes_before);
    std::vector<std::string> parts;
    int other = followed_ - clear_;
    for (const auto& [name, count] : settled_) {
      parts.push_back(fmt::format("{} on ({}, {}) orbits", count, name.first, name.second));
      other -= count;
    }
    if (clear_ > 0) parts.push_back(fmt::format("{} without impacts", clear_));
    if (other > 0) parts.push_back(fmt::format("{} on motions that are not listed", other));
    found_.notes.push_back(fmt::format("{} motions from quasi-random initial states settle: {}",
                                       followed_, fmt::join(parts, ", ")));
  }

  const System& system_;
  const FinderOptions& options_;
  const long long most_work_;
  FoundOrbits& found_;
  const MotionScale scale_;
  boost::random::sobol numbers_;
  std::vector<std::uint64_t> shift_;
  std::vector<Orbit> known_;  // stable
  std::map<std::pair<int, int>, int> settled_;
  int followed_ = 0, clear_ = 0;
  bool any_new_ = false;
};

}  // namespace

void add_settled_orbits(const System& system, const FinderOptions& options, long long most_work,
                        FoundOrbits& found) {
  if (system.is_self_excited()) return;  // its periods are not known
  if (places_of_starts(system) > kMostStops) {
    found.notes.push_back(fmt::format(
        "with more than {} stops no motions from quasi-random initial states are simulated",
        kMostStops));
    return;
  }
  Spread(system, options, most_work, found).follow();
}

}  // namespace graze
