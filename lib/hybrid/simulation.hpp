// A run: the motion from its initial state until its end, its budget or its rest on a stop.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/system/system.hpp"

namespace graze {

enum class EventKind { kImpact };

struct Event {
  EventKind kind = EventKind::kImpact;
  double time = 0.0;            // s
  long long period_index = 0;   // whole forcing periods before it
  int stop = 0;                 // index from 0
  double speed = 0.0;           // approach speed just before, m/s, > 0
  std::optional<double> phase;  // (frequency t + phase) mod 2 pi, rad; absent without forcing
  double energy_change = 0.0;   // of the kinetic energy, J
};

struct Sample {
  double time = 0.0;  // s
  State state;
};

// Who wants to hear of the run as it goes; an empty function is never called and costs nothing.
struct RunListeners {
  std::function<void(const Event&)> event;
  std::function<void(const Sample&)> sample;
  double sample_rate = 0.0;                       // 1/s, with `sample`
  std::function<void(double fraction)> progress;  // once per forcing period
};

struct SimulationOptions {
  // The end: `duration` seconds when given, else `periods` forcing periods.
  std::optional<double> duration;
  long long periods = 100;
  long long max_impacts = 10'000'000;
  StopSignal stop;
};

enum class RunOutcome { kReachedEnd, kEventBudget, kTimeBudget, kNotFinite, kInterrupted };

struct RunTotals {
  long long impacts = 0;
  long long undecided_touches = 0;     // grazings within rounding, passed without impact
  double stuck_time = 0.0;             // s
  double energy_added = 0.0;           // by impacts that gained kinetic energy, J
  double energy_lost = 0.0;            // by impacts that lost kinetic energy, J
  std::optional<double> smallest_gap;  // over the whole run and all stops, m; absent without stops
};

struct Simulation {
  RunOutcome outcome = RunOutcome::kReachedEnd;
  std::string message;  // a sentence unless the end was reached
  double end_time = 0.0;
  State final;
  std::optional<int> resting_stop;  // the motion came to rest on this stop (index from 0)
  RunTotals totals;
};

// Runs the system from `start` at t = 0. Requires forcing or a duration.
Simulation simulate(const System& system, const State& start, const SimulationOptions& options,
                    const RunListeners& listeners = {});

}  // namespace graze
