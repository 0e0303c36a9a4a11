#include "graze/flow/detail/phase_choice.hpp"

#include "graze/flow/held/detail/coupled_phase.hpp"
#include "graze/flow/held/detail/held_exactly.hpp"
#include "graze/flow/held/detail/series_phase.hpp"
#include "graze/flow/sprung/detail/linear_spring_phase.hpp"
#include "graze/flow/sprung/detail/turning_phase.hpp"

namespace graze {
template <>
std::unique_ptr<ContactPhase<double>> make_contact_phase(const System& system, const PhaseKey& key,
                                                         const std::optional<StepSetting>& steps,
                                                         double angle) {
  if (system.turns()) return std::make_unique<TurningPhase>(system, key, steps, angle);
  if (!key.springs.empty()) {
    if (!steps && suits_linear_springs(system, key))
      return std::make_unique<LinearSpringPhase>(system, key);
    return std::make_unique<SprungPhase>(system, key, steps);
  }
  if (!steps && suits_series(system, key.closed)) return std::make_unique<SeriesPhase>(system, key);
  std::unique_ptr<ExactPhase<double>> exact = exact_phase(system, key);
  if (!steps) return exact;
  return std::make_unique<SteppedPhase>(std::move(exact), *steps);
}

}  // namespace graze
