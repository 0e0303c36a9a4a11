#include "graze/system/hub_state.hpp"

namespace graze {

HubState hub_state(const Rotation& rotation, const State& state) {
  return {rotation.angle.dot(state.q),
          rotation.angle.dot(state.qdot),
          {rotation.beam * state.q, rotation.beam * state.qdot}};
}

Vector decay_rates(const System& system) {
  if (!system.rotation || system.rotation->damping.size() == 0) return system.delta;
  return 0.5 * system.rotation->damping.diagonal();
}

}  // namespace graze
