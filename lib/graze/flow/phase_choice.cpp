#include "graze/flow/detail/phase_choice.hpp"

#include "graze/flow/held/detail/coupled_phase.hpp"
#include "graze/flow/sprung/detail/turning_phase.hpp"

namespace graze {
namespace {

std::unique_ptr<ExactPhase<double>> exact_phase(const System& system, const PhaseKey& key) {
  if (key.closed.empty()) return std::make_unique<FreePhase<double>>(system, key);
  ConstrainedStructure<double> structure(system, key.closed);
  if (structure.has_real_modes)
    return std::make_unique<ConstrainedPhase<double>>(system, key, std::move(structure));
  const CoupledSystem equations = couple(structure);
  return std::make_unique<CoupledPhase>(system, key, std::move(structure), equations);
}

}  // namespace

template <>
std::unique_ptr<ContactPhase<double>> make_contact_phase(const System& system, const PhaseKey& key,
                                                         const std::optional<StepSetting>& steps,
                                                         double angle) {
  if (system.turns()) return std::make_unique<TurningPhase>(system, key, steps, angle);
  if (!key.springs.empty()) return std::make_unique<SprungPhase>(system, key, steps);
  std::unique_ptr<ExactPhase<double>> exact = exact_phase(system, key);
  if (!steps) return exact;
  return std::make_unique<SteppedPhase>(std::move(exact), *steps);
}

}  // namespace graze
