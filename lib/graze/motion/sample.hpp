// A sample of a run.
#pragma once

#include <cmath>
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

// How many samples of a rate (1/s), counted from t = 0, come before a time (s).
inline long long samples_before(double time, double rate) {
  constexpr double kMost = 0x1p62;  // that can be counted
  return static_cast<long long>(std::fmin(std::ceil(time * rate), kMost));
}

}  // namespace graze
