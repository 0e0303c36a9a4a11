// Chooses the class that follows a phase of the motion.
#pragma once

#include <memory>
#include <optional>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/stepped/step_setting.hpp"

namespace graze {

// `steps`: the motion is integrated step by step; absent: it is exact except on springs and hubs.
// `angle`: of a joint that is held, rad. The 50-digit phases support neither steps nor springs nor
// hubs; systems with these must not be passed to them.
template <class Real>
std::unique_ptr<ContactPhase<Real>> make_contact_phase(const System& system, const PhaseKey& key,
                                                       const std::optional<StepSetting>& steps = {},
                                                       double angle = 0.0);

// The system with the load of what slides; nothing else of its friction acts.
System under_friction(const System& system, const PhaseKey& key);
// Its derivative along the system's tangent.
System under_friction_rate(const System& system, const System& tangent, const PhaseKey& key);

}  // namespace graze
