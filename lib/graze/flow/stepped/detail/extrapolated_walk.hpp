// Steps through a contact by extrapolation (Bulirsch and Stoer), with Boost.Odeint, for any law of
// the contact. Included by the translation units whose walks take such steps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/stepped/detail/extrapolation.hpp"
#include "graze/flow/stepped/detail/step_walk.hpp"

namespace graze::step_walk {

namespace odeint = boost::numeric::odeint;

// Steps and orders are chosen by their error. A state within a step is computed from its start, or
// from one of the last two states that were asked for: a search for an instant then takes ever
// shorter steps.
class ExtrapolatedWalk {
 public:
  using RatesOf = Sprung;
  using State = Sprung::State;

  ExtrapolatedWalk(Sprung rates_of, const StepSetting& setting)
      : rates(std::move(rates_of)),
        longest_(setting.longest),
        method_(made(setting)),
        method_within_(made(setting)) {}

  void begin(const State& x) {
    from_ = to_ = 0.0;
    next_ = rates.first_step(longest_);
    at_start_ = at_end_ = x;
    forget_within();
    method_.reset();
  }
  void step() {
    at_start_ = at_end_;
    from_ = to_;
    forget_within();
    next_ = std::fmin(next_, rates.longest_step());
    for (int i = 0; i < kMostFailures; ++i)
      if (method_.try_step(std::ref(rates), at_start_, to_, at_end_, next_) == odeint::success)
        return;
  }
  double from() const { return from_; }
  double to() const { return to_; }
  const State& state_at_end() const { return at_end_; }
  void between(double s, State& x) {
    double at = from_;
    const State* nearest = &at_start_;
    for (const Known& known : known_)
      if (known.at <= s && known.at > at) {
        at = known.at;
        nearest = &known.state;
      }
    x = *nearest;
    method_within_.reset();
    double next = s - at;
    for (int i = 0; i < kMostFailures && at < s && !StopScope::is_over(); ++i) {
      next = std::min(next, s - at);
      within_ = x;
      if (method_within_.try_step(std::ref(rates), within_, at, x, next) != odeint::success)
        x = within_;
    }
    if (at < s)
      x.assign(x.size(), std::numeric_limits<double>::quiet_NaN());
    else
      keep_within(s, x);
  }

  Sprung rates;

 protected:
  // Goes on from a state that was reached otherwise, s seconds after the start; `step` is tried
  // first.
  void go_on(double s, const State& x, double step) {
    to_ = s;
    at_end_ = x;
    next_ = step;
    method_.reset();
  }

 private:
  static Extrapolation made(const StepSetting& setting) {
    return extrapolation(setting.tolerance * setting.speed, Sprung::relative(setting.tolerance),
                         std::isfinite(setting.longest) ? setting.longest : 0.0);
  }

  // A state within the step.
  struct Known {
    double at = std::numeric_limits<double>::infinity();
    State state;
  };
  void forget_within() {
    for (Known& known : known_) known.at = std::numeric_limits<double>::infinity();
  }
  // Replaces a known state after s, else the earlier one: the search goes on between.
  void keep_within(double s, const State& x) {
    const bool first_is_later = known_[0].at > known_[1].at;
    const bool later_is_after = std::max(known_[0].at, known_[1].at) > s;
    Known& replaced = known_[first_is_later == later_is_after ? 0 : 1];
    replaced.at = s;
    replaced.state = x;
  }

  double longest_;
  double from_ = 0.0, to_ = 0.0, next_ = 0.0;
  State at_start_{}, at_end_{}, within_{};
  std::array<Known, 2> known_;
  // The method adapts to its steps; steps within a step must not influence it.
  Extrapolation method_, method_within_;
};

}  // namespace graze::step_walk
