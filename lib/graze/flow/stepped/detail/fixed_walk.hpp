// Walks of steps of one length, and the choice between these and adaptive ones (step_walk.hpp).
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "graze/flow/stepped/detail/step_walk.hpp"

namespace graze::step_walk {

// For a method that keeps the slope at the end of a step for the next one: passes it the slope,
// since steps within a step start elsewhere.
template <class Stepper>
class Unprepared {
 public:
  template <class Rates, class State>
  void do_step(Rates rates, const State& x, double s, State& out, double step) {
    State slope = x, slope_out = x;
    rates(x, slope, s);
    stepper_.do_step(rates, x, slope, s, out, slope_out, step);
  }

 private:
  Stepper stepper_;
};

// Steps of one length.
template <class Rates, class Stepper>
class FixedWalk {
 public:
  using RatesOf = Rates;
  using State = typename Rates::State;

  FixedWalk(Rates rates_of, double step) : rates(std::move(rates_of)), step_(step) {}

  void begin(const State& x) {
    taken_ = 0;
    at_start_ = at_end_ = x;
  }
  void step() {
    at_start_ = at_end_;
    stepper_.do_step(std::ref(rates), at_start_, to(), at_end_, step_);
    ++taken_;
  }
  double from() const { return taken_ > 0 ? static_cast<double>(taken_ - 1) * step_ : 0.0; }
  double to() const { return static_cast<double>(taken_) * step_; }
  const State& state_at_end() const { return at_end_; }
  // Rarely called, and kept out of the loop over the steps, which is faster without it.
  [[gnu::noinline]] void between(double s, State& x) {
    x = at_start_;
    if (s > from()) stepper_.do_step(std::ref(rates), at_start_, from(), x, s - from());
  }

  Rates rates;

 private:
  double step_;
  long long taken_ = 0;
  State at_start_{}, at_end_{};
  Stepper stepper_;
};

// Steps of one length by Stepper where the setting has one; else adaptive steps.
template <class Stepper, class Adaptive, class Rates>
std::unique_ptr<StepFlow> fixed_or_adaptive(const Rates& rates, const StepSetting& setting) {
  using Fixed = FixedWalk<Rates, Stepper>;
  if (setting.step > 0.0) return std::make_unique<WalkingFlow<Fixed>>(Fixed(rates, setting.step));
  return std::make_unique<WalkingFlow<Adaptive>>(Adaptive(rates, setting));
}

// Calls make(rates) with the right-hand side of these modes; states have a fixed size for a few
// numbers of modes.
template <class Make>
std::unique_ptr<StepFlow> with_rates(const ModalRates& rates, const Make& make) {
  switch (rates.scale.size()) {
    case 1:
      return make(SideBySide<1>(rates));
    case 2:
      return make(SideBySide<2>(rates));
    case 3:
      return make(SideBySide<3>(rates));
    case 4:
      return make(SideBySide<4>(rates));
    case 8:
      return make(SideBySide<8>(rates));
    default:
      return make(SideBySide<0>(rates));
  }
}

}  // namespace graze::step_walk
