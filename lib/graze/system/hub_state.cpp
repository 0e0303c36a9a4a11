#include "graze/system/detail/hub_state.hpp"

namespace graze {

HubState hub_state(const Rotation& rotation, const State& state) {
  return {rotation.angle.dot(state.q),
          rotation.angle.dot(state.qdot),
          {rotation.beam * state.q, rotation.beam * state.qdot}};
}

Vector decay_rates(const System& system) {
  if (!system.turns()) return system.delta();
  const Matrix& damping = system.rotation()->damping;
  return damping.size() > 0 ? Vector(0.5 * damping.diagonal()) : Vector::Zero(system.modes());
}

}  // namespace graze
