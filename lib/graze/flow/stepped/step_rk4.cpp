#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "graze/flow/stepped/detail/fixed_walk.hpp"

namespace graze {
namespace {

template <class Rates>
std::unique_ptr<StepFlow> by_rk4(const Rates& rates, const StepSetting& setting) {
  using Stepper = boost::numeric::odeint::runge_kutta4<typename Rates::State>;
  using Walk = step_walk::FixedWalk<Rates, Stepper>;
  return std::make_unique<step_walk::WalkingFlow<Walk>>(Walk(rates, setting.step));
}

}  // namespace

std::unique_ptr<StepFlow> rk4_flow(const ModalRates& rates, const StepSetting& setting) {
  return step_walk::with_rates(rates, [&](const auto& side) { return by_rk4(side, setting); });
}

std::unique_ptr<StepFlow> rk4_flow(const FirstOrderSystem& system, const StepSetting& setting) {
  return by_rk4(step_walk::Dense(system), setting);
}

std::unique_ptr<StepFlow> rk4_flow(const SprungSystem& system, const StepSetting& setting) {
  return by_rk4(step_walk::Sprung(system, setting.tolerance), setting);
}

}  // namespace graze
