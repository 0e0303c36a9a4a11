// How long and where the phases of impacts are searched for (phase_search.hpp).
#pragma once

#include <cstdint>

#include "graze/base/stop_signal.hpp"

namespace graze {

struct PhaseSearchOptions {
  int starts = 64;  // of a round
  int rounds = 8;   // at most
  // Start only where every stop is approached. No solution is excluded, but a start is more likely
  // to lead to an orbit: an orbit is surrounded by such points.
  bool approaching = true;
  int global_evaluations = 2048;
  std::uint64_t seed = 1;  // moves the Sobol sequence
  double length = 1.0;     // m, unit of the residual
  double speed = 1.0;      // m/s, of the forced motion; r(v) is taken there at first
  int threads = 0;         // 0: as many as there are cores
  StopSignal stop;
};

}  // namespace graze
