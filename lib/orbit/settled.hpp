// What a simulation settles on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {

struct SettledMotion {
  // The repeating pattern, with the points of its last repetition; nothing when none was found. It
  // need not be minimal: where deviations alternate in sign, two periods agree before one does.
  std::optional<ImpactPattern> pattern;
  std::vector<ImpactPoint> points;
  bool sticks = false;  // it came to rest on a stop, or nearly: what follows was not looked at
  std::string verdict;  // a sentence: what the motion does
};

struct SettleOptions {
  long long periods = 3000;  // simulated at most
  int longest_period = 32;   // longest orbit looked for, in forcing periods
  long long max_impacts = 10'000'000;
  StopSignal stop;
};

// Simulates from `start` until the impacts repeat. They count as repeating when phases (rad) and
// relative speeds of the last three repetitions agree to 1e-6: near enough for Newton, which then
// decides.
SettledMotion settle(const System& system, const State& start, const SettleOptions& options = {});

}  // namespace graze
