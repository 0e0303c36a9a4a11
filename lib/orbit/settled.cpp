#include "graze/orbit/settled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "graze/base/angle.hpp"
#include "graze/hybrid/motion.hpp"

namespace graze {
namespace {

constexpr double kRepeats = 1e-6;
constexpr int kRepetitions = 3;

struct Met {
  long long period;
  int stop;
  double phase, speed;
  State before;
};

// Whether the impacts of the last kRepetitions * p whole periods repeat after p.
bool repeats(const std::deque<Met>& met, long long now, int p) {
  const long long from = now - static_cast<long long>(kRepetitions) * p;
  std::vector<const Met*> tail;
  for (const Met& m : met)
    if (m.period >= from && m.period < now) tail.push_back(&m);
  std::size_t k = 0;
  while (k < tail.size() && tail[k]->period < from + p) ++k;
  if (k == 0 || tail.size() != k * kRepetitions) return false;
  for (std::size_t i = k; i < tail.size(); ++i) {
    const Met &a = *tail[i - k], &b = *tail[i];
    if (b.period != a.period + p || b.stop != a.stop) return false;
    if (std::abs(b.phase - a.phase) > kRepeats ||
        std::abs(b.speed - a.speed) > kRepeats * (std::abs(a.speed) + std::abs(b.speed)))
      return false;
  }
  return true;
}

SettledMotion settled_on(const std::deque<Met>& met, long long now, int p) {
  SettledMotion result;
  ImpactPattern pattern{p, {}};
  for (const Met& m : met) {
    if (m.period < now - p || m.period >= now) continue;
    pattern.stops.push_back(m.stop);
    result.points.push_back(
        {m.phase + kTurn * static_cast<double>(m.period - (now - p)), m.before});
  }
  result.verdict =
      fmt::format("from the scene's initial state {} impacts repeat every {} forcing periods",
                  pattern.impacts(), p);
  result.pattern = std::move(pattern);
  return result;
}

SettledMotion unsettled(std::string verdict) {
  SettledMotion result;
  result.verdict = std::move(verdict);
  return result;
}

}  // namespace

SettledMotion settle(const System& system, const State& start, const SettleOptions& options) {
  // An impact this much more frequent than the forcing is chatter, not a pattern to look for.
  constexpr std::size_t kMostImpactsPerPeriod = 4096;
  const double still = still_speed(system);
  Motion<double> motion(system, {}, start.q, start.qdot);
  std::deque<Met> met;
  std::size_t in_period = 0;
  long long impacts = 0;
  while (motion.instant().period < options.periods) {
    if (options.stop.requested()) return unsettled("stopped before the motion settled");
    if (impacts >= options.max_impacts)
      return unsettled(fmt::format("the budget of {} impacts was spent before the motion settled",
                                   options.max_impacts));
    const Arrival<double> arrival = motion.fly(motion.flow().period());
    const Instant<double>& now = motion.instant();
    if (arrival.kind == ArrivalKind::kStick || arrival.kind == ArrivalKind::kRefused) {
      SettledMotion result = unsettled(
          fmt::format("from the scene's initial state the motion comes to rest on stop {} in "
                      "forcing period {}",
                      arrival.stop + 1, now.period + 1));
      result.sticks = true;
      return result;
    }
    if (arrival.kind == ArrivalKind::kContact && arrival.speed <= still) {
      SettledMotion result =
          unsettled(fmt::format("from the scene's initial state the impacts on stop {} die out "
                                "in forcing period {}",
                                arrival.stop + 1, now.period + 1));
      result.sticks = true;
      return result;
    }
    if (arrival.kind == ArrivalKind::kContact) {
      met.push_back({now.period,
                     arrival.stop,
                     motion.flow().phase(now),
                     arrival.speed,
                     {motion.q(), motion.qdot()}});
      motion.impact();
      ++impacts;
      if (++in_period > kMostImpactsPerPeriod) {
        SettledMotion result =
            unsettled("from the scene's initial state the motion impacts without end");
        result.sticks = true;
        return result;
      }
      continue;
    }
    if (arrival.kind == ArrivalKind::kTouch) continue;
    if (arrival.kind != ArrivalKind::kTime)
      return unsettled("the simulation from the scene's initial state could not go on");
    in_period = 0;
    const long long keep = static_cast<long long>(kRepetitions) * options.longest_period;
    while (!met.empty() && met.front().period < now.period - keep) met.pop_front();
    for (int p = 1; p <= options.longest_period && kRepetitions * p <= now.period; ++p)
      if (repeats(met, now.period, p)) return settled_on(met, now.period, p);
  }
  if (impacts == 0) return unsettled("from the scene's initial state the motion meets no stop");
  if (met.empty())
    return unsettled("from the scene's initial state the motion settles clear of every stop");
  return unsettled(
      fmt::format("from the scene's initial state no pattern of up to {} forcing "
                  "periods repeats within {} periods",
                  options.longest_period, options.periods));
}

}  // namespace graze
