#include "graze/flow/exact_phase.hpp"
#include "graze/flow/extended.hpp"
#include "graze/flow/phase_choice.hpp"

namespace graze {

template <>
std::unique_ptr<ContactPhase<Extended>> make_contact_phase(
    const System& system, const PhaseKey& key, const std::optional<StepSetting>& /*steps*/,
    double /*angle*/) {
  if (key.closed.empty()) return std::make_unique<FreePhase<Extended>>(system, key);
  return std::make_unique<HeldPhase<Extended>>(system, key,
                                               HeldStructure<Extended>(system, key.closed));
}

}  // namespace graze
