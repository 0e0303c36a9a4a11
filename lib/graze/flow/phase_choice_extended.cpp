#include "graze/flow/detail/phase_choice.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/flow/held/detail/exact_phase.hpp"

namespace graze {

template <>
std::unique_ptr<ContactPhase<Extended>> make_contact_phase(
    const System& system, const PhaseKey& key, const std::optional<StepSetting>& /*steps*/,
    double /*angle*/) {
  if (key.closed.empty()) return std::make_unique<FreePhase<Extended>>(system, key);
  return std::make_unique<ConstrainedPhase<Extended>>(
      system, key, ConstrainedStructure<Extended>(system, key.closed, key.places));
}

}  // namespace graze
