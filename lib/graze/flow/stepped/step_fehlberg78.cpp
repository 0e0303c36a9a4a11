#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "graze/flow/stepped/detail/fixed_walk.hpp"

namespace graze {
namespace {

namespace odeint = boost::numeric::odeint;

// A step that fails its error more often than this in a row will not succeed.
constexpr int kMostFailures = 500;

// The estimate of Fehlberg's 7(8) compares only stages at the two ends of a step: it is zero for x'
// = f(t). The step itself sums f by the seven-point rule of Newton and Cotes, with an error of
// (9/1400)(h/6)^9 f^(8); steps are kept so short that for a harmonic force this is within the
// tolerance.
double longest_step_of_force(double frequency, double tolerance) {
  if (!(frequency > 0.0)) return std::numeric_limits<double>::infinity();
  return 6.0 / frequency * std::pow(1400.0 / 9.0 * tolerance, 1.0 / 9.0);
}

// Adaptive steps; a state within one is computed by a shorter step from the same start.
template <class Rates>
class ControlledWalk {
 public:
  using RatesOf = Rates;
  using State = typename Rates::State;

  ControlledWalk(Rates rates_of, const StepSetting& setting)
      : rates(std::move(rates_of)),
        longest_(
            std::min(setting.longest, longest_step_of_force(rates.frequency(), setting.tolerance))),
        controlled_(odeint::make_controlled(setting.tolerance * setting.speed,
                                            Rates::relative(setting.tolerance), longest_,
                                            Method())) {}

  void begin(const State& x) {
    from_ = to_ = 0.0;
    next_ = rates.first_step(longest_);
    at_start_ = at_end_ = x;
  }
  void step() {
    at_start_ = at_end_;
    from_ = to_;
    for (int i = 0; i < kMostFailures; ++i)
      if (controlled_.try_step(std::ref(rates), at_start_, to_, at_end_, next_) == odeint::success)
        return;
  }
  double from() const { return from_; }
  double to() const { return to_; }
  const State& state_at_end() const { return at_end_; }
  void between(double s, State& x) {
    x = at_start_;
    if (s > from_) method_.do_step(std::ref(rates), at_start_, from_, x, s - from_);
  }

  Rates rates;

 private:
  using Method = odeint::runge_kutta_fehlberg78<State>;
  double longest_;
  double from_ = 0.0, to_ = 0.0, next_ = 0.0;
  State at_start_{}, at_end_{};
  typename odeint::result_of::make_controlled<Method>::type controlled_;
  Method method_;
};

template <class Rates>
std::unique_ptr<StepFlow> by_fehlberg78(const Rates& rates, const StepSetting& setting) {
  using Stepper = odeint::runge_kutta_fehlberg78<typename Rates::State>;
  return step_walk::fixed_or_adaptive<Stepper, ControlledWalk<Rates>>(rates, setting);
}

}  // namespace

std::unique_ptr<StepFlow> fehlberg78_flow(const ModalRates& rates, const StepSetting& setting) {
  return step_walk::with_rates(rates,
                               [&](const auto& side) { return by_fehlberg78(side, setting); });
}

std::unique_ptr<StepFlow> fehlberg78_flow(const FirstOrderSystem& system,
                                          const StepSetting& setting) {
  return by_fehlberg78(step_walk::Dense(system), setting);
}

std::unique_ptr<StepFlow> fehlberg78_flow(const SprungSystem& system, const StepSetting& setting) {
  return by_fehlberg78(step_walk::Sprung(system, setting.tolerance), setting);
}

}  // namespace graze
