#include "graze/flow/detail/phase_choice.hpp"

#include "graze/flow/held/detail/coupled_phase.hpp"
#include "graze/flow/held/detail/held_exactly.hpp"
#include "graze/flow/held/detail/series_phase.hpp"
#include "graze/flow/sprung/detail/linear_spring_phase.hpp"
#include "graze/flow/sprung/detail/turning_phase.hpp"
#include "graze/flow/variation/detail/deviation.hpp"

namespace graze {

System under_friction(const System& system, const PhaseKey& key) {
  System loaded = system;
  std::optional<Vector>& load = loaded.modal().load;
  if (!load) load = Vector::Zero(system.modes());
  *load += friction_push(system, key.frictions);
  return loaded;
}

System under_friction_rate(const System& system, const System& tangent, const PhaseKey& key) {
  System loaded = tangent;
  Vector load = tangent.load() ? *tangent.load() : Vector(Vector::Zero(system.modes()));
  for (std::size_t k = 0; k < key.frictions.size(); ++k) {
    const Friction &friction = system.frictions[k], &rate = tangent.frictions[k];
    const Vector push = rate.sliding * friction.row + friction.sliding * rate.row;
    if (key.frictions[k] == Contact::kForward) load -= push;
    if (key.frictions[k] == Contact::kBackward) load += push;
  }
  loaded.modal().load = std::move(load);
  return loaded;
}

namespace {

// Of a system under the load of what slides.
std::unique_ptr<ContactPhase<double>> phase_of(const System& system, const PhaseKey& key,
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

}  // namespace

template <>
std::unique_ptr<ContactPhase<double>> make_contact_phase(const System& system, const PhaseKey& key,
                                                         const std::optional<StepSetting>& steps,
                                                         double angle) {
  if (key.frictions.empty()) return phase_of(system, key, steps, angle);
  return phase_of(under_friction(system, key), key, steps, angle);
}

}  // namespace graze
