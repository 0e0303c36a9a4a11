// A sample of a run.
#pragma once

#include <optional>
#include <vector>

#include "graze/motion/energy_balance.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct Sample {
  double time = 0.0;  // s
  State state;
  std::vector<double> forces;           // contact force at every stop, N; 0 where it is open
  std::optional<EnergyBalance> energy;  // up to this instant, when the run keeps the balance
};

}  // namespace graze
