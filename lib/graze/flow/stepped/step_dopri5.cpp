#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "graze/flow/stepped/detail/fixed_walk.hpp"

namespace graze {
namespace {

namespace odeint = boost::numeric::odeint;

// Adaptive steps; within one the method's own polynomial is used.
template <class Rates>
class DenseWalk {
 public:
  using RatesOf = Rates;
  using State = typename Rates::State;

  DenseWalk(Rates rates_of, const StepSetting& setting)
      : rates(std::move(rates_of)),
        longest_(setting.longest),
        stepper_(odeint::make_controlled(setting.tolerance * setting.speed,
                                         Rates::relative(setting.tolerance), longest_, Method())) {}

  void begin(const State& x) { stepper_.initialize(x, 0.0, rates.first_step(longest_)); }
  void step() {
    try {
      stepper_.do_step(std::ref(rates));
    } catch (const odeint::no_progress_error&) {  // the end stays where it was
    }
  }
  double from() const { return to() > 0.0 ? stepper_.previous_time() : 0.0; }
  double to() const { return stepper_.current_time(); }
  const State& state_at_end() const { return stepper_.current_state(); }
  void between(double s, State& x) {
    if (to() > 0.0)
      stepper_.calc_state(s, x);
    else
      x = state_at_end();
  }

  Rates rates;

 private:
  using Method = odeint::runge_kutta_dopri5<State>;
  double longest_;
  using Controlled = typename odeint::result_of::make_controlled<Method>::type;
  odeint::dense_output_runge_kutta<Controlled> stepper_;
};

template <class Rates>
std::unique_ptr<StepFlow> by_dopri5(const Rates& rates, const StepSetting& setting) {
  using Stepper = odeint::runge_kutta_dopri5<typename Rates::State>;
  return step_walk::fixed_or_adaptive<step_walk::Unprepared<Stepper>, DenseWalk<Rates>>(rates,
                                                                                        setting);
}

}  // namespace

std::unique_ptr<StepFlow> dopri5_flow(const ModalRates& rates, const StepSetting& setting) {
  return step_walk::with_rates(rates, [&](const auto& side) { return by_dopri5(side, setting); });
}

std::unique_ptr<StepFlow> dopri5_flow(const FirstOrderSystem& system, const StepSetting& setting) {
  return by_dopri5(step_walk::Dense(system), setting);
}

std::unique_ptr<StepFlow> dopri5_flow(const SprungSystem& system, const StepSetting& setting) {
  return by_dopri5(step_walk::Sprung(system, setting.tolerance), setting);
}

}  // namespace graze
