// Whether a simulated motion repeats, seen at the starts of forcing periods. Chatters are summed as
// in a run, so it goes on through sticking.
#pragma once

#include <string>

#include "graze/base/stop_signal.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct RepetitionOptions {
  double closure_speed = 0.0;  // m/s
  long long periods = 3000;    // simulated at most
  int longest_period = 32;     // longest repetition looked for, in forcing periods
  long long max_impacts = 10'000'000;
  StopSignal stop;
};

struct Repetition {
  int period = 0;       // p, forcing periods; 0: none was found
  State at_start;       // at the start of the last repetition
  bool sticks = false;  // some stop was closed during it
  std::string why_not;  // a sentence where none was found
};

// Simulates from `start` until the states at starts of forcing periods, in units of
// `shooting_scale`, agree to 1e-6 over three repetitions: near enough for Newton, which then
// decides. Requires forcing.
Repetition find_repetition(const System& system, const State& start,
                           const RepetitionOptions& options);

}  // namespace graze
