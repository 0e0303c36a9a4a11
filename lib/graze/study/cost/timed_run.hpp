// A simulation and the computing time that it takes.
#pragma once

#include "graze/motion/simulation.hpp"

namespace graze {

// s: the measurement for a row of a table ends when it has taken this long, after at least one run.
inline constexpr double kRowSeconds = 0.5;

struct TimedRun {
  Simulation run;
  double seconds = 0.0;  // of computing time, of one run
  // The same, and the counts of the run, per forcing period (per second without forcing); 0 where
  // the run did not advance.
  double seconds_per_period = 0.0, evaluations_per_period = 0.0, impacts_per_period = 0.0;
};

// Repeats the run as least_time (processor_time.hpp) does. `enough`: s.
TimedRun timed_run(const System& system, const State& start, const SimulationOptions& options,
                   double enough = kRowSeconds);

}  // namespace graze
