#include "graze/system/hub_state.hpp"

namespace graze {

HubState hub_state(const Rotation& rotation, const State& state) {
  return {rotation.angle.dot(state.q),
          rotation.angle.dot(state.qdot),
          {rotation.beam * state.q, rotation.beam * state.qdot}};
}

}  // namespace graze
