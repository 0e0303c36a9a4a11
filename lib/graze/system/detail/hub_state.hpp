// The state of a structure on a hub as angle, rate and modal coordinates of the beam.
#pragma once

#include "graze/system/system.hpp"

namespace graze {

struct HubState {
  double angle = 0.0, rate = 0.0;  // rad, rad/s
  State beam;                      // modal coordinates of the clamped beam, N
};

HubState hub_state(const Rotation& rotation, const State& state);

// Decay rate of each natural mode alone, 1/s; on a hub the damping couples the modes.
Vector decay_rates(const System& system);

}  // namespace graze
