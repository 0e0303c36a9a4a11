// What a self-excited motion (System::is_self_excited) settles on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/orbit/problem/detail/followed_orbit.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct SelfExcitedCycle {
  double period = 0.0;  // s
  State start;          // where the first friction's place is at rest
};
struct SelfExcitedAnswer {
  std::optional<SelfExcitedCycle> cycle;
  std::string classification;  // a sentence
};

// Follows the motion from `start` until its slips repeat. They count as repeating when the times
// between them agree to 1e-6 of the period over the last repetitions.
SelfExcitedAnswer self_excited_cycle(const System& system, const State& start,
                                     const StopSignal& stop = {});

// The orbit near that cycle; what the motion settles on is noted.
FollowedAnswer self_excited_orbit(const System& system, const State& start,
                                  const SegmentOptions& options, std::vector<std::string>& notes);

}  // namespace graze
