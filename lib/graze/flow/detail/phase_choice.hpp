// Which of the phases a motion is in.
#pragma once

#include <memory>
#include <optional>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/stepped/step_setting.hpp"

namespace graze {

// `steps`: the motion is integrated step by step; absent: it is exact but on springs and hubs.
// `angle`: of a joint that is held, rad. The 50-digit phases know neither steps nor springs nor
// hubs: a system that has them is not given to them.
template <class Real>
std::unique_ptr<ContactPhase<Real>> make_contact_phase(const System& system, const PhaseKey& key,
                                                       const std::optional<StepSetting>& steps = {},
                                                       double angle = 0.0);

}  // namespace graze
