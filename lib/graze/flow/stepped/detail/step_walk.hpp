// How a method of Boost.Odeint walks along a piece of motion (step_flow.hpp), whatever the state
// type. Included by one translation unit per method.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/base/detail/bracketed_zero.hpp"
#include "graze/base/stop_scope.hpp"
#include "graze/flow/stepped/detail/sprung_rates_changed_impl.hpp"
#include "graze/flow/stepped/detail/sprung_rates_turning_impl.hpp"
#include "graze/flow/stepped/detail/step_methods.hpp"
#include "graze/flow/stepped/detail/step_rates.hpp"

namespace graze {

namespace step_walk {

// A Walk takes steps from a start: begin(x), step(), from(), to(), state_at_end(), between(s, out)
// within the step taken last; it holds its right-hand side as `rates`.
template <class Walk>
class WalkingFlow final : public StepFlow {
 public:
  using State = typename Walk::State;

  explicit WalkingFlow(Walk walk) : walk_(std::move(walk)) {}

  void start(double theta, const Vector& x, std::span<const double> depths, double time) override {
    if constexpr (kSprung) walk_.rates.set_time(time);
    walk_.rates.begin(theta, x, depths, start_);
    within_ = last_ = start_;
    walk_.begin(start_);
    if constexpr (kSprung) {
      peaks_.assign(walk_.rates.springs(), {});
      for (std::size_t i = 0; i < peaks_.size(); ++i) {
        const auto [depth, rate] = walk_.rates.compression(i, start_);
        peaks_[i] = {walk_.rates.force(i, start_), walk_.rates.force_rate(i, 0.0, start_), depth,
                     depth, rate};
      }
    }
  }

  StepDescent first_descent(std::span<const Watch* const> watches, double window, double until,
                            const StopSignal& stop, double told_depth) override {
    StepDescent found;
    found.s = window;
    found.lowest = std::numeric_limits<double>::infinity();
    live_.clear();
    for (const Watch* watch : watches)
      live_.push_back(watch->leaving == Leaving::kKnown ? watch->sure : found.lowest);
    if constexpr (kSprung) {
      slopes_.clear();
      // A watch that leaves a known zero rises; the sign of its rate may be rounding.
      for (std::size_t i = 0; i < watches.size(); ++i)
        slopes_.push_back(watches[i]->multiplicity > 0 || live_[i] > 0.0
                              ? 0.0
                              : walk_.rates.rate(*watches[i], 0.0, start_));
    }
    [[maybe_unused]] long long steps = 0;
    for (double from = 0.0; from < std::min(window, until) && found.watch < 0;) {
      walk_.step();
      if (StopScope::is_over() || (++polls_ % kStepsPerPoll == 0 && stop.requested())) {
        found.stopped = true;
        return found;
      }
      const double end = std::min(walk_.to(), window);
      if (!(end > from)) return not_finite(found, from);
      if constexpr (kSprung) {
        if (end < walk_.to()) walk_.between(end, last_);
        const State& x = end < walk_.to() ? last_ : walk_.state_at_end();
        if (tells(watches, x, end, ++steps, found)) {
          found.s = end;
          return watches[static_cast<std::size_t>(found.watch)]->of_spring == SpringWatch::kRest
                     ? well_left(watches, end, steps, window, found)
                     : found;
        }
      }
      const int parts = parts_of(end - from);
      double part_from = from;
      for (int part = 1; part <= parts && found.watch < 0; ++part) {
        const double part_end = part < parts ? from + (end - from) * part / parts : end;
        if (!look(watches, part_from, part_end, until, found)) return not_finite(found, from);
        part_from = part_end;
      }
      if constexpr (kSprung) pass_peaks(from, std::min(end, found.s), told_depth);
      from = end;
    }
    return found;
  }

  void state(double s, Vector& x) override {
    reach(s);
    walk_.rates.whole(within_, x);
  }

  void each_step(double until, const std::function<void(double, double)>& visit) override {
    walk_.begin(start_);
    for (double from = 0.0; from < until && !StopScope::is_over();) {
      walk_.step();
      const double to = std::min(walk_.to(), until);
      if (!(to > from)) return;
      // There is nothing between neighbouring numbers.
      if (to - from <= kNothing * to) {
        from = to;
        continue;
      }
      // Walks with long steps divide them into parts.
      if constexpr (requires { walk_.parts(to); })
        for (int i = 1, parts = walk_.parts(to); i < parts; ++i) {
          const double end = walk_.part_end(i, to);
          visit(from, end);
          from = end;
        }
      visit(from, to);
      from = to;
    }
  }

  SprungWorks works(double s) override {
    if constexpr (kSprung) {
      reach(s);
      return walk_.rates.works(within_);
    }
    return {};
  }

  long long evaluations() const override { return walk_.rates.evaluations; }

  double peak_force(std::size_t spring) const override {
    if constexpr (kSprung) return peaks_[spring].force;
    return 0.0;
  }

  double deepest(std::size_t spring) const override {
    if constexpr (kSprung) return peaks_[spring].depth;
    return 0.0;
  }

 private:
  static constexpr bool kSprung = requires(const typename Walk::RatesOf& rates) {
    rates.springs();
  };

  // Number of parts in which a step is searched: in half a period of the fastest oscillation a
  // watch hardly falls and rises more than once.
  int parts_of(double step) const {
    if constexpr (kSprung) {
      const double turned = walk_.rates.quickest() * step;
      if (turned > kTurn / 2.0)
        return static_cast<int>(std::ceil(std::fmin(turned, kMostTurned) / (kTurn / 2.0)));
    }
    return 1;
  }

  // Finds the first watch to fall through zero within (from, end] of the last step; returns false
  // where one is not finite.
  bool look(std::span<const Watch* const> watches, double from, double end, double until,
            StepDescent& found) {
    if (end < walk_.to()) walk_.between(end, last_);
    const State& x = end < walk_.to() ? last_ : walk_.state_at_end();
    found.values += static_cast<long long>(watches.size());
    for (std::size_t i = 0; i < watches.size(); ++i) {
      if (end <= live_[i]) continue;
      const double there = walk_.rates.observed(*watches[i], end, x);
      if (!std::isfinite(there)) return false;
      if (end <= until && watches[i]->is_told) found.lowest = std::min(found.lowest, there);
      const std::optional<double> zero = fall(watches, i, from, end, there, until, found);
      if (!zero || (found.watch >= 0 && !(*zero < found.s))) continue;
      found.watch = static_cast<int>(i);
      found.s = *zero;
    }
    return true;
  }

  struct Peak {
    double force = 0.0, force_rate = 0.0;  // N; N/s, at the end of the last step
    double depth = 0.0;                    // m
    double at = 0.0, depth_rate = 0.0;     // m, m/s: there, likewise
  };

  // Puts the state at s into within_.
  void reach(double s) {
    if (s < walk_.from()) walk_.begin(start_);
    while (walk_.to() < s && !StopScope::is_over()) {
      const double before = walk_.to();
      walk_.step();
      if (!(walk_.to() > before)) break;
    }
    within(s);
  }

  // Puts the state at s, within the last step, into within_.
  const State& within(double s) {
    if (s == walk_.to())
      within_ = walk_.state_at_end();
    else
      walk_.between(s, within_);
    return within_;
  }

  // The largest forces of springs within (from, end], and their largest depths beyond `told_depth`;
  // for an undamped spring both are at the same instant.
  void pass_peaks(double from, double end, double told_depth) {
    at_end_ = within(end);
    for (std::size_t i = 0; i < peaks_.size(); ++i) {
      Peak& peak = peaks_[i];
      const auto look = [&](const State& z) {
        peak.depth = std::max(peak.depth, walk_.rates.compression(i, z).depth);
        peak.force = std::max(peak.force, walk_.rates.force(i, z));
      };
      const auto pass = [&](double before, double after, const auto& rate_at) {
        if (before > 0.0 && after < 0.0)
          look(within(bracketed_zero(rate_at, {from, before}, {end, after}).first));
      };
      look(at_end_);
      const auto [depth, rate] = walk_.rates.compression(i, at_end_);
      const bool damped = walk_.rates.is_damped(i);
      // A depth that reverses lies below its tangents at both ends.
      const double tangents = peak.at + peak.depth_rate * (depth - peak.at - rate * (end - from)) /
                                            (peak.depth_rate - rate);
      if (!damped || tangents > told_depth)
        pass(peak.depth_rate, rate,
             [&](double s) { return walk_.rates.compression(i, within(s)).rate; });
      if (damped) {
        const double force_rate = walk_.rates.force_rate(i, end, at_end_);
        pass(peak.force_rate, force_rate,
             [&](double s) { return walk_.rates.force_rate(i, s, within(s)); });
        peak.force_rate = force_rate;
      }
      peak.at = depth;
      peak.depth_rate = rate;
    }
  }

  // The fall through zero of a watch that is positive at both ends of (from, end], but falls at the
  // first and rises at the second.
  std::optional<double> dip_between(const Watch& watch, double from, double end, double slope,
                                    double until, StepDescent& found) {
    const auto slope_at = [&](double s) {
      walk_.between(s, within_);
      return walk_.rates.rate(watch, s, within_);
    };
    const double first = slope_at(from);
    if (!(first < 0.0)) return {};
    const double least = bracketed_zero(slope_at, {from, first}, {end, slope}).first;
    walk_.between(least, within_);
    const double value = walk_.rates.observed(watch, least, within_);
    found.values += 1;
    if (least <= until && watch.is_told) found.lowest = std::min(found.lowest, value);
    if (value > 0.0) return {};
    return locate(watch, from, least, value, found.values);
  }

  // Where a watch falls through zero in (from, end]; its value at the end is `there`.
  std::optional<double> fall(std::span<const Watch* const> watches, std::size_t i, double from,
                             double end, double there, double until, StepDescent& found) {
    const Watch& watch = *watches[i];
    const double begin = std::max(from, live_[i]);
    if constexpr (kSprung) {
      const State& x = end < walk_.to() ? last_ : walk_.state_at_end();
      const double slope = walk_.rates.rate(watch, end, x);
      const bool dips = there > 0.0 && slopes_[i] < 0.0 && slope > 0.0;
      slopes_[i] = slope;
      if (dips) return dip_between(watch, begin, end, slope, until, found);
    }
    if (there > 0.0) return {};
    return locate(watch, begin, end, there, found.values);
  }

  // Whether a watch that started at zero in an unknown way now certainly differs from zero; until
  // then its motion makes no difference. A contact force that may still turn out to be zero is
  // counted among the errors of depths.
  bool tells(std::span<const Watch* const> watches, const State& x, double end, long long steps,
             StepDescent& found) {
    double pull = 0.0;  // m/s^2
    found.errors.assign(watches.size(), 0.0);
    for (std::size_t i = 0; i < watches.size(); ++i) {
      const Watch& watch = *watches[i];
      if (watch.leaving == Leaving::kKnown || watch.of_spring == SpringWatch::kRest ||
          end > live_[i])
        continue;
      const auto changed = walk_.rates.changed(watch, end, x, steps);
      found.errors[i] = changed.error;
      if (watch.leaving == Leaving::kAsked) pull += changed.error * watch.mobility;
      if (!changed.is_certain()) continue;
      live_[i] = end;
      if (watch.leaving == Leaving::kAwaited && changed.value > 0.0) continue;
      found.watch = static_cast<int>(i);
      found.beyond = changed.value > 0.0;
    }
    for (std::size_t i = 0; i < watches.size() && found.watch < 0; ++i) {
      if (watches[i]->of_spring != SpringWatch::kRest) continue;
      const auto spring = static_cast<std::size_t>(watches[i]->spring);
      auto left = walk_.rates.left(spring, x, steps);
      left.error += 0.5 * end * end * pull * walk_.rates.system().springs[spring].row.norm();
      if (!left.is_certain()) continue;
      found.watch = static_cast<int>(i);
      found.beyond = left.value > 0.0;
    }
    return found.watch >= 0;
  }

  bool happens_nothing(std::span<const Watch* const> watches, const State& x, double end,
                       long long steps) {
    for (std::size_t i = 0; i < watches.size(); ++i) {
      const Watch& watch = *watches[i];
      if (watch.of_spring == SpringWatch::kRest) continue;
      if (end > live_[i] ? !(walk_.rates.observed(watch, end, x) > 0.0)
                         : watch.leaving != Leaving::kKnown &&
                               walk_.rates.changed(watch, end, x, steps).is_certain())
        return false;
    }
    return true;
  }

  // From there on the spring is followed while it moves away and no other event occurs: the later
  // search for its surface takes short steps near a zero.
  StepDescent well_left(std::span<const Watch* const> watches, double end, long long steps,
                        double window, StepDescent found) {
    const auto spring =
        static_cast<std::size_t>(watches[static_cast<std::size_t>(found.watch)]->spring);
    const double sign = found.beyond ? 1.0 : -1.0;
    double away = 0.0;
    for (;;) {
      const State& x = end < walk_.to() ? last_ : walk_.state_at_end();
      const auto [depth, error] = walk_.rates.left(spring, x, steps++);
      const bool goes_on = happens_nothing(watches, x, end, steps);
      if (away > 0.0 && (!(sign * depth > away) || !goes_on)) return found;
      found.s = end;
      away = sign * depth;
      if (away > kWellLeft * error || !goes_on || !(walk_.to() < window)) return found;
      walk_.step();
      if (!(walk_.to() > end)) return found;
      end = std::min(walk_.to(), window);
      if (end < walk_.to()) walk_.between(end, last_);
    }
  }

  // The result at the last instant with a finite state.
  static StepDescent not_finite(StepDescent found, double from) {
    found.finite = false;
    found.s = from;
    return found;
  }

  // The zero of a watch that is not positive at the end of (from, end]. One that starts at a zero
  // is divided by that power, so that it starts at its departure. Kept out of the loop over the
  // steps.
  [[gnu::noinline]] double locate(const Watch& watch, double from, double end, double at_end,
                                  long long& values) {
    if (!(end > from)) return from;
    const bool departs = from == 0.0 && watch.multiplicity > 0 && !is_grip(watch);
    const auto quotient = [&](double s, double v) {
      return departs ? v / std::pow(s, watch.multiplicity) : v;
    };
    const auto at = [&](double s) {
      if (s == from && departs) return watch.departure;
      walk_.between(s, within_);
      ++values;
      return quotient(s, walk_.rates.observed(watch, s, within_));
    };
    const double first = at(from), last = quotient(end, at_end);
    if (!(first > 0.0)) return from;
    if (last == 0.0) return end;
    return bracketed_zero(at, {from, first}, {end, last}).second;
  }

  // A grip has left its zero once it differs by more than its rounding (Sprung::observed).
  static bool is_grip(const Watch& watch) {
    return watch.of_spring == SpringWatch::kGrip || watch.of_spring == SpringWatch::kSlack;
  }

  static constexpr long long kStepsPerPoll = 4096;
  // Radians of the fastest oscillation that are searched part by part within one step, which bounds
  // the cost of a step. Over more, the parts are longer than half a period, and a fall and rise of
  // that oscillation within one of them may be missed.
  static constexpr double kMostTurned = 64.0;
  // So many errors of a depth away from its zero, a search makes long steps.
  static constexpr double kWellLeft = 1e6;
  // Relative to the time so far: a step so short has no room for the nodes of a quadrature rule.
  static constexpr double kNothing = 1024.0 * std::numeric_limits<double>::epsilon();
  Walk walk_;
  long long polls_ = 0;
  State start_, within_, last_, at_end_;
  std::vector<Peak> peaks_;
  std::vector<double> slopes_;  // of the watches, at the end of the step before
  std::vector<double> live_;    // s, from when on a fall of each watch counts
};

}  // namespace step_walk
}  // namespace graze
