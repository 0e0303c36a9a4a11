// The methods that a motion can be integrated with step by step.
#pragma once

#include <memory>

#include "graze/flow/stepped/detail/step_flow.hpp"
#include "graze/flow/stepped/step_setting.hpp"

namespace graze {

std::unique_ptr<StepFlow> step_flow(const ModalRates& rates, const StepSetting& setting);
std::unique_ptr<StepFlow> step_flow(const FirstOrderSystem& system, const StepSetting& setting);
std::unique_ptr<StepFlow> step_flow(const SprungSystem& system, const StepSetting& setting);

// These use the named method, whatever the setting's.
std::unique_ptr<StepFlow> rk4_flow(const ModalRates& rates, const StepSetting& setting);
std::unique_ptr<StepFlow> rk4_flow(const FirstOrderSystem& system, const StepSetting& setting);
std::unique_ptr<StepFlow> rk4_flow(const SprungSystem& system, const StepSetting& setting);
std::unique_ptr<StepFlow> dopri5_flow(const ModalRates& rates, const StepSetting& setting);
std::unique_ptr<StepFlow> dopri5_flow(const FirstOrderSystem& system, const StepSetting& setting);
std::unique_ptr<StepFlow> dopri5_flow(const SprungSystem& system, const StepSetting& setting);
std::unique_ptr<StepFlow> fehlberg78_flow(const ModalRates& rates, const StepSetting& setting);
std::unique_ptr<StepFlow> fehlberg78_flow(const FirstOrderSystem& system,
                                          const StepSetting& setting);
std::unique_ptr<StepFlow> fehlberg78_flow(const SprungSystem& system, const StepSetting& setting);
std::unique_ptr<StepFlow> bulirsch_stoer_flow(const SprungSystem& system,
                                              const StepSetting& setting);
// Uses power series where the law of the contact has them (contact_series.hpp), else extrapolation.
std::unique_ptr<StepFlow> contact_flow(const SprungSystem& system, const StepSetting& setting);

}  // namespace graze
