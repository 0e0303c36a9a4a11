#include "graze/orbit/search/detail/settling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

constexpr double kRepeats = 1e-6;
constexpr int kRepetitions = 3;
// Bound on the numbers that the history stores for the states before the impacts of one period, 256
// MiB. The number of impacts of a motion is bounded by the budget of the options, which a finite
// burst does not exhaust; impacts without end at one instant are detected by the motion.
constexpr long long kMostNumbersPerPeriod = 1 << 25;
constexpr double kLost = 1e-3;  // a motion this far from an orbit is on its way elsewhere
constexpr const char* kSettlesClear = "settles on a motion without impacts";
constexpr int kPatience = 32;  // repetitions until the stability of an orbit is computed again

long long remembered(const SettleOptions& options) {
  const long long repetitions = options.nearness ? 2 * PeriodHistory::kWindow + 1 : kRepetitions;
  return std::max(repetitions * options.longest_period, options.tail);
}

std::string count(long long number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

}  // namespace

Settling::Settling(const System& system, const State& start, SettleOptions options)
    : system_(system),
      options_(std::move(options)),
      flow_(system),
      closure_speed_(options_.closure_speed.value_or(default_closure_speed(system, start))),
      history_(system, start, remembered(options_)),
      scale_(motion_scale(system)) {
  if (options_.periods <= 0) conclude_unsettled();
}

SettledMotion Settling::result() {
  result_.periods = history_.periods();
  if (result_.at_end.q.size() == 0) result_.at_end = history_.state_at_start(result_.periods);
  return std::move(result_);
}

bool Settling::add_impact(int stop, double local, double speed, const Vector& q,
                          const Vector& qdot) {
  if (result_.impacts_met >= options_.max_impacts)
    return end(SettledKind::kImpactBudget, fmt::format("spent the budget of {} before it settled",
                                                       count(options_.max_impacts, "impact")));
  if (++in_period_ > kMostNumbersPerPeriod / (2 * system_.modes()))
    return end(SettledKind::kImpactBudget,
               fmt::format("had more impacts in forcing period {} than can be stored, {}",
                           periods() + 1, in_period_ - 1));
  ++result_.impacts_met;
  history_.add_impact({periods(), stop, flow_.phase({periods(), local}), speed}, q, qdot);
  return true;
}

void Settling::end_period(const Vector& q, const Vector& qdot, PeriodHistory::Contacts contacts) {
  history_.end_period(q, qdot, contacts);
  if (options_.repeats_after == 0)
    look_back(q, qdot, !contacts.any);
  else if (history_.periods() == options_.repeats_after)
    conclude_periodic(options_.repeats_after);
  in_period_ = 0;
  if (!over_ && history_.periods() >= options_.periods) conclude_unsettled();
}

void Settling::refuse(const std::string& failure) {
  end(SettledKind::kRefused, fmt::format("ends in forcing period {}: {}", periods() + 1, failure));
}

bool Settling::stop_requested(bool reads_clock) {
  const bool late = reads_clock && options_.stop.is_late();
  if (!late && !options_.stop.is_interrupted()) return false;
  end(late ? SettledKind::kTimeBudget : SettledKind::kInterrupted, "was stopped before it settled");
  return true;
}

void Settling::look_back(const Vector& q, const Vector& qdot, bool is_free) {
  if (options_.nearness == 0.0) return;
  if (in_period_ == 0 && is_free && conclude_clear(q, qdot)) return;
  if (approached_) return come_nearer();
  const int p = repetition();
  if (p == 0) return;
  const long long from = history_.periods() - p;
  const bool contacts = history_.contacts_since(from).any;
  const bool impacts_alone = history_.impact_count_since(from) > 0 && !contacts;
  if (!options_.nearness) {
    // A drift too slow to see may still lead to a stop: clearance has to be certain.
    if (impacts_alone || contacts) conclude_periodic(p);
    return;
  }
  if (impacts_alone && history_.periods() >= next_solve_) {
    const Pattern motion = pattern_of_last(p);
    approached_ = nearby_orbit(system_, motion.pattern, motion.points);
    if (approached_ && approached_->stable == true) {
      solved_at_ = history_.periods();
      return come_nearer();
    }
    const bool unstable = approached_ && approached_->stable == false;
    approached_.reset();
    next_solve_ = history_.periods() + static_cast<long long>(kPatience) * p;
    if (unstable) leaving_until_ = next_solve_;
  }
  // Near an orbit that it will leave again.
  if (history_.periods() < leaving_until_) return;
  // While the last difference alone exceeds the nearness, the estimate is not needed.
  if (!(history_.difference(p) < *options_.nearness)) return;
  const double remaining = history_.remaining(p);
  if (remaining < *options_.nearness) conclude_near(p, remaining);
}

// The orbit is known: compares the motion with it once a repetition.
void Settling::come_nearer() {
  const int p = approached_->pattern.period;
  if ((history_.periods() - solved_at_) % p != 0) return;
  const Pattern motion = pattern_of_last(p);
  left_ = motion.pattern.stops == approached_->pattern.stops
              ? distance(system_, scale_, *approached_, motion.points)
              : std::numeric_limits<double>::infinity();
  if (left_ < *options_.nearness)
    conclude_near(p, left_);
  else if (!(left_ <= kLost))
    approached_.reset();
}

void Settling::conclude_near(int p, double remaining) {
  result_.near = true;
  conclude_repeating(p, remaining);
}

// An orbit that repeats a shorter one is replaced by that.
void Settling::conclude_repeating(int p, double remaining) {
  int least = p;
  if (approached_)
    least = shortest_period(system_, *approached_, kShootingAccuracy);
  else if (std::isfinite(remaining))
    for (int q = p - 1; q > 0; --q)
      if (p % q == 0 && history_.difference(q) < 4.0 * std::max(remaining, *options_.nearness))
        least = q;
  result_.remaining = remaining;
  conclude_periodic(least);
}

// The smallest p after which the motion repeats, or 0.
int Settling::repetition() const {
  return history_.repetition(options_.longest_period, kRepetitions, kRepeats);
}

bool Settling::conclude_clear(const Vector& q, const Vector& qdot) {
  if (!clearance_) clearance_.emplace(system_, flow_);
  if (!clearance_->is_sure(q, qdot)) return false;
  result_.kind = SettledKind::kClear;
  result_.period = 1;
  result_.near = true;
  result_.remaining = 0.0;
  result_.at_start = result_.at_end = clearance_->steady();
  result_.period_states = {clearance_->steady()};
  end_clear();
  return true;
}

void Settling::end_clear() {
  end(SettledKind::kClear, result_.impacts_met == 0 ? "meets no stop" : kSettlesClear);
}

void Settling::conclude_periodic(int p) {
  const long long from = history_.periods() - p;
  const auto contacts = history_.contacts_since(from);
  keep_since(from);
  result_.period = p;
  result_.sticks = contacts.closed;
  const std::string every = "every " + (p == 1 ? "forcing period" : count(p, "forcing period"));
  if (contacts.held) {
    end(SettledKind::kAtRest, "stays on the stop for ever");
  } else if (contacts.closed) {
    end(SettledKind::kSticks, "comes to rest on a stop and is released, the same " + every);
  } else if (result_.impacts.empty()) {
    if (contacts.sprung)
      end(SettledKind::kAtRest, "stays on the stop for ever");
    else
      end_clear();
  } else {
    end(SettledKind::kImpacts,
        fmt::format("settles on {} that {} {}",
                    count(static_cast<long long>(result_.impacts.size()), "impact"),
                    result_.impacts.size() == 1 ? "repeats" : "repeat", every));
    if (!system_.has_modal_flights()) return;  // it is followed
    Pattern last = pattern_of_last(p);
    result_.pattern = std::move(last.pattern);
    result_.points = std::move(last.points);
  }
}

Settling::Pattern Settling::pattern_of_last(int p) const {
  Pattern last{{p, {}}, {}};
  const long long from = history_.periods() - p;
  const std::vector<MetImpact> impacts = history_.impacts_since(from);
  const std::vector<State> before = history_.states_before_impacts_since(from);
  for (std::size_t i = 0; i < before.size(); ++i) {
    last.pattern.stops.push_back(impacts[i].stop);
    last.points.push_back(
        {impacts[i].phase + kTurn * static_cast<double>(impacts[i].period - from), before[i]});
  }
  return last;
}

void Settling::conclude_unsettled() {
  // It repeats, but not within the nearness: reported as such, with its repetition. The budget may
  // end within a repetition; the distance is that at the end of the last whole one.
  if (approached_) return conclude_repeating(approached_->pattern.period, left_);
  if (const int p = options_.nearness ? repetition() : 0)
    return conclude_repeating(p, history_.remaining(p));
  keep_since(std::max(history_.oldest(), history_.periods() - options_.tail));
  end(SettledKind::kNotPeriodic,
      result_.impacts_met == 0
          ? fmt::format("meets no stop within {}", count(options_.periods, "forcing period"))
      : result_.impacts.empty() && history_.contacts_since(history_.oldest()).any == false
          ? kSettlesClear
          : fmt::format("repeats no pattern of up to {} forcing periods within {}",
                        options_.longest_period, count(options_.periods, "period")));
}

void Settling::keep_since(long long from) {
  result_.at_start = history_.state_at_start(from);
  result_.sticks = history_.contacts_since(from).closed;
  result_.impacts = history_.impacts_since(from);
  for (long long n = from; n < history_.periods(); ++n)
    result_.period_states.push_back(history_.state_at_start(n));
}

bool Settling::end(SettledKind kind, const std::string& what) {
  over_ = true;
  result_.kind = kind;
  result_.classification = fmt::format("from {} the motion {}", options_.from, what);
  if (options_.nearness > 0.0 && result_.period > 0 && !result_.near)
    result_.classification +=
        fmt::format(", but {} within {}",
                    std::isfinite(result_.remaining)
                        ? fmt::format("comes no nearer than {:.3g}", result_.remaining)
                        : "at a distance that does not shrink",
                    count(options_.periods, "forcing period"));
  return false;
}

}  // namespace graze
