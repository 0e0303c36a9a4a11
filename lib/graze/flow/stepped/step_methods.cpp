#include "graze/flow/stepped/detail/step_methods.hpp"

namespace graze {
namespace {

template <class Rates>
std::unique_ptr<StepFlow> by_method(const Rates& rates, const StepSetting& setting) {
  switch (setting.method) {
    case StepMethod::kRk4:
      return rk4_flow(rates, setting);
    case StepMethod::kDopri5:
      return dopri5_flow(rates, setting);
    case StepMethod::kFehlberg78:
      return fehlberg78_flow(rates, setting);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<StepFlow> step_flow(const ModalRates& rates, const StepSetting& setting) {
  return by_method(rates, setting);
}

std::unique_ptr<StepFlow> step_flow(const FirstOrderSystem& system, const StepSetting& setting) {
  return by_method(system, setting);
}

std::unique_ptr<StepFlow> step_flow(const SprungSystem& system, const StepSetting& setting) {
  return by_method(system, setting);
}

}  // namespace graze
