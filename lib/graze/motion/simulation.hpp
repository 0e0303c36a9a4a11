// A run: the motion from its initial state until its end or its budget, event by event.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/flow/exact/motion_state.hpp"
#include "graze/flow/stepped/step_setting.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/motion/run_events.hpp"
#include "graze/motion/spring_contact.hpp"

namespace graze {

struct SimulationOptions {
  // The end: `duration` seconds after t = 0 when given, else `periods` forcing periods.
  std::optional<double> duration;
  long long periods = 100;
  long long max_impacts = kDefaultImpactBudget;
  // Speed below which a chatter is summed, m/s; see default_closure_speed.
  std::optional<double> closure_speed;
  bool energy = false;                      // keep the energy balance
  std::optional<MeasureOptions> measure{};  // absent: it is not
  std::optional<StepSetting> steps{};       // integrate step by step; absent: the exact flow
                                            // (dry friction, which steps do not know, needs it)
  StopSignal stop;
};

// Speed v below which the tail of a chatter is summed by default: the summation has an error of
// about 100 (v/V)^2 of a forcing period at r = 0.8, V the speed of the motion, so v = V
// sqrt(tolerance/100). `tolerance`: that of the scene, a part of a forcing period; or the default
// one.
double default_closure_speed(const System& system, const State& start,
                             double tolerance = kDefaultTolerance);

// A sentence for each rigid stop on which the structure cannot be held: under an oblique impulse
// law the motion there can grow without bound, and a simulation that comes to rest there ends.
std::vector<std::string> unstable_stops(const System& system);

// Everything needed to continue a run as if it had never ended: the start of its last arc.
struct RunState {
  MotionState<double> motion;
  bool started = false;  // something has happened since t = 0
  struct Streak {        // impacts on a stop that fall in speed
    long long impacts = 0;
    double speed = 0.0;
    void add(double next) {
      impacts = next < speed ? impacts + 1 : 1;
      speed = next;
    }
  };
  std::vector<Streak> streaks;      // per stop
  SpringContacts contacts;          // per stop
  std::optional<ChatterTail> tail;  // of a chatter that was summed, until it is over
  RunTotals totals;
  bool keeps_balance = false;
  EnergyBalance balance;
  long long samples = 0;       // counted so far
  double closure_speed = 0.0;  // m/s
};

struct Simulation {
  RunOutcome outcome = RunOutcome::kReachedEnd;
  std::string message;  // a sentence unless the end was reached
  // When the budget was spent on events that crowd together: which stops have how many
  // (event_crowd.hpp). Covers only this part of a run that was cut.
  std::string crowd;
  double end_time = 0.0;
  State final;         // of the system
  double phase = 0.0;  // of the forcing at the end, rad; 0 without
  std::vector<int> stuck;      // closed stops at the end (index from 0)
  std::vector<double> forces;  // contact forces at the end, N, one per stop
  std::vector<AtFriction> frictions;  // at the end
  RunTotals totals;
  std::optional<EnergyBalance> energy;
  std::optional<Amplitudes> amplitudes;  // where they were asked for
  // Evaluations of gaps and contact forces in the search for events, and of the equations of motion
  // on springs; with `steps` of the equations of motion alone.
  long long evaluations = 0;
  RunState state;  // to go on from
};

// Runs the system from `start` at t = 0. Requires forcing or a duration.
Simulation simulate(const System& system, const State& start, const SimulationOptions& options,
                    const RunListeners& listeners = {});

// Continues from the state that an earlier run of the same system left; later events are, bit for
// bit, those of a run that was never cut.
Simulation resume(const System& system, const RunState& from, const SimulationOptions& options,
                  const RunListeners& listeners = {});

}  // namespace graze
