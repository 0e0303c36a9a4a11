// The state of a structure on a hub in its own terms.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

struct HubState {
  double angle = 0.0, rate = 0.0;  // rad, rad/s
  State beam;                      // modal coordinates of the clamped beam, N
};

HubState hub_state(const Rotation& rotation, const State& state);

// Of each natural mode by itself, 1/s; on a hub the modes share their damping.
Vector decay_rates(const System& system);

}  // namespace graze
