// How a method of Boost.Odeint walks along a piece of motion (step_flow.hpp), whatever the state
// type. Included by one translation unit per method.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "graze/base/bracketed_zero.hpp"
#include "graze/flow/step_methods.hpp"

namespace graze {

namespace step_walk {

template <class State>
void assign(State& to, const Vector& from) {
  if constexpr (requires { to.resize(0); }) to.resize(static_cast<std::size_t>(from.size()));
  std::copy(from.begin(), from.end(), to.begin());
}

// The right-hand side for N modes; N = 0: as many as there are.
template <std::size_t N>
class SideBySide {
 public:
  using State = std::conditional_t<N == 0, std::vector<double>, std::array<double, 2 * N>>;

  explicit SideBySide(const ModalRates& rates) : frequency_(rates.frequency) {
    assign(scale_, rates.scale);
    assign(stiffness_, rates.stiffness);
    assign(damping_, rates.damping);
    assign(load_, rates.load);
    assign(force_, rates.force);
  }
  // The two never overlap; a compiler that is told takes several modes at once.
  void operator()(const State& __restrict x, State& __restrict slope, double s) {
    ++evaluations;
    const std::size_t n = N == 0 ? scale_.size() : N;
    // Stages come in pairs at one instant.
    if (frequency_ > 0.0 && s != known_at_) {
      known_at_ = s;
      cosine_ = std::cos(theta_ + frequency_ * s);
    }
    for (std::size_t j = 0; j < n; ++j) {
      slope[j] = scale_[j] * x[n + j];
      slope[n + j] = load_[j] + force_[j] * cosine_ - damping_[j] * x[n + j] - stiffness_[j] * x[j];
    }
  }
  double frequency() const { return frequency_; }
  // At the start of the piece.
  double phase() const { return theta_; }
  void set_phase(double theta) {
    theta_ = theta;
    known_at_ = -1.0;
  }

  long long evaluations = 0;

 private:
  using PerMode = std::conditional_t<N == 0, std::vector<double>, std::array<double, N>>;
  PerMode scale_{}, stiffness_{}, damping_{}, load_{}, force_{};
  double frequency_, theta_ = 0.0;
  double known_at_ = -1.0, cosine_ = 1.0;  // of the force, and where
};

class Dense {
 public:
  using State = std::vector<double>;

  explicit Dense(const FirstOrderSystem& system) : system_(system) {}
  void operator()(const State& x, State& slope, double s) {
    ++evaluations;
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::Map<Vector>(slope.data(), n).noalias() =
        system_.generator * Eigen::Map<const Vector>(x.data(), n) + system_.load +
        system_.force * std::cos(theta_ + system_.frequency * s);
  }
  double frequency() const { return system_.frequency; }
  double phase() const { return theta_; }
  void set_phase(double theta) { theta_ = theta; }

  long long evaluations = 0;

 private:
  FirstOrderSystem system_;
  double theta_ = 0.0;
};

// A Walk takes steps from a start: begin(x), step(), from(), to(), state_at_end(), between(s, out)
// within the step taken last; it holds its right-hand side as `rates`.
template <class Walk>
class WalkingFlow final : public StepFlow {
 public:
  using State = typename Walk::State;

  WalkingFlow(Walk walk, const StopSignal& stop) : walk_(std::move(walk)), stop_(stop) {}

  void start(double theta, const Vector& x) override {
    walk_.rates.set_phase(theta);
    assign(start_, x);
    within_ = start_;
    walk_.begin(start_);
  }

  StepDescent first_descent(std::span<const Watch* const> watches, double window,
                            double until) override {
    StepDescent found;
    found.s = window;
    found.lowest = std::numeric_limits<double>::infinity();
    for (double from = 0.0; from < std::min(window, until) && found.watch < 0;) {
      walk_.step();
      if (++polls_ % kStepsPerPoll == 0 && stop_.requested()) {
        found.stopped = true;
        return found;
      }
      const double end = std::min(walk_.to(), window);
      if (!(end > from)) return not_finite(found);
      if (end < walk_.to()) walk_.between(end, within_);
      const State& x = end < walk_.to() ? within_ : walk_.state_at_end();
      found.values += static_cast<long long>(watches.size());
      for (std::size_t i = 0; i < watches.size(); ++i) {
        const double there = value(*watches[i], end, x);
        if (!std::isfinite(there)) return not_finite(found);
        if (end <= until) found.lowest = std::min(found.lowest, there);
        if (there > 0.0) continue;
        const double zero = locate(*watches[i], from, end, there, found.values);
        if (found.watch >= 0 && !(zero < found.s)) continue;
        found.watch = static_cast<int>(i);
        found.s = zero;
      }
      from = end;
    }
    return found;
  }

  void state(double s, Vector& x) override {
    if (s < walk_.from()) walk_.begin(start_);
    while (walk_.to() < s) {
      const double before = walk_.to();
      walk_.step();
      if (!(walk_.to() > before)) break;
    }
    if (s == walk_.to())
      within_ = walk_.state_at_end();
    else
      walk_.between(s, within_);
    x = Eigen::Map<const Vector>(within_.data(), static_cast<Eigen::Index>(within_.size()));
  }

  long long evaluations() const override { return walk_.rates.evaluations; }

 private:
  static StepDescent not_finite(StepDescent found) {
    found.finite = false;
    return found;
  }

  double value(const Watch& watch, double s, const State& x) const {
    double sum = watch.constant;
    for (std::size_t j = 0; j < x.size(); ++j)
      sum += watch.weights[static_cast<Eigen::Index>(j)] * x[j];
    if (watch.harmonic_re == 0.0 && watch.harmonic_im == 0.0) return sum;
    const double theta = walk_.rates.phase() + walk_.rates.frequency() * s;
    return sum + watch.harmonic_re * std::cos(theta) - watch.harmonic_im * std::sin(theta);
  }

  // The zero of a watch that is not positive at the end of (from, end]. One that starts at a zero
  // is divided by that: what is left starts at its departure. Kept out of the loop over the steps.
  [[gnu::noinline]] double locate(const Watch& watch, double from, double end, double at_end,
                                  long long& values) {
    const bool departs = from == 0.0 && watch.multiplicity > 0;
    const auto quotient = [&](double s, double v) {
      return departs ? v / std::pow(s, watch.multiplicity) : v;
    };
    const auto at = [&](double s) {
      if (s == from && departs) return watch.departure;
      walk_.between(s, within_);
      ++values;
      return quotient(s, value(watch, s, within_));
    };
    const double first = at(from), last = quotient(end, at_end);
    if (!(first > 0.0)) return from;
    if (last == 0.0) return end;
    return bracketed_zero(at, {from, first}, {end, last}).second;
  }

  static constexpr long long kStepsPerPoll = 4096;
  Walk walk_;
  StopSignal stop_;
  long long polls_ = 0;
  State start_, within_;
};

// A method that keeps the slope at the end of a step for the next one, with the slope told to it:
// steps within a step start from elsewhere.
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
  // Seldom called, and kept out of the loop over the steps, which is the quicker for it.
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

// Steps of one length by Stepper where the setting has one; else those that Adaptive decides.
template <class Stepper, class Adaptive, class Rates>
std::unique_ptr<StepFlow> fixed_or_adaptive(const Rates& rates, const StepSetting& setting) {
  using Fixed = FixedWalk<Rates, Stepper>;
  if (setting.step > 0.0)
    return std::make_unique<WalkingFlow<Fixed>>(Fixed(rates, setting.step), setting.stop);
  return std::make_unique<WalkingFlow<Adaptive>>(Adaptive(rates, setting), setting.stop);
}

// Calls make(rates) with the right-hand side of the modes there are; a few numbers of modes have
// states of fixed size.
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

}  // namespace step_walk
}  // namespace graze
