// A run: the motion from its initial state until its end or its budget, event by event.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/default_budget.hpp"
#include "graze/base/default_tolerance.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/hybrid/contact_book.hpp"
#include "graze/hybrid/energy_book.hpp"
#include "graze/hybrid/next_flight.hpp"
#include "graze/hybrid/sampler.hpp"

namespace graze {

// kContact and kSeparation: at a compliant stop.
enum class EventKind { kImpact, kChatter, kStick, kRelease, kContact, kSeparation };

struct Event {
  EventKind kind = EventKind::kImpact;
  double time = 0.0;           // s
  long long period_index = 0;  // whole forcing periods before it
  int stop = 0;                // index from 0
  // Impact: approach speed just before, m/s, > 0; forcing phase (frequency t + phase) mod 2 pi,
  // rad, absent without forcing; change of the kinetic energy, J.
  double speed = 0.0;
  std::optional<double> phase{};
  double energy_change = 0.0;
  // Chatter, at its last resolved impact: how many impacts on this stop fell in speed one after the
  // other up to it, and the speed below which the rest was summed, m/s. Stops that share a chatter
  // are reported one by one; the energy stands with the one hit last (fastest).
  long long impacts = 0;
  double closure_speed = 0.0;
  // Stick: the contact force that sets in, N.
  double force = 0.0;
  // Contact: speed and phase as of an impact. Separation: the speed away from the stop, how long
  // the contact took, s, its largest force, N, the part of its speed that it gave back, absent
  // where it began at rest, and as energy change minus what the stop took meanwhile.
  double duration = 0.0;
  double peak_force = 0.0;
  std::optional<double> effective_restitution{};
};

// Who wants to hear of the run as it goes; an empty function is never called and costs nothing.
struct RunListeners {
  std::function<void(const Event&)> event;
  std::function<void(const Sample&)> sample;
  double sample_rate = 0.0;                       // 1/s, with `sample`
  std::function<void(double fraction)> progress;  // once per forcing period
};

struct SimulationOptions {
  // The end: `duration` seconds after t = 0 when given, else `periods` forcing periods.
  std::optional<double> duration;
  long long periods = 100;
  long long max_impacts = kDefaultImpactBudget;
  // Speed below which a chatter is summed, m/s; see default_closure_speed.
  std::optional<double> closure_speed;
  bool energy = false;                 // keep the energy book
  std::optional<StepSetting> steps{};  // integrate step by step; absent: the exact flow
  StopSignal stop;
};

// Summing the tail of a chatter from speed v on errs by about 100 (v/V)^2 of a forcing period at
// r = 0.8, V the speed of the motion: v = V sqrt(tolerance/100). `tolerance`: that of the scene, a
// part of a forcing period; else that of a scene which names none.
double default_closure_speed(const System& system, const State& start,
                             double tolerance = kDefaultTolerance);

enum class RunOutcome {
  kReachedEnd,
  kEventBudget,
  kTimeBudget,
  kNotFinite,
  kRefused,  // the motion on a stop cannot be followed: its law makes it grow without bound
  kInterrupted
};

struct RunTotals {
  long long impacts = 0;
  long long chatters = 0;              // summed, or followed down to rounding
  long long clamped_restitutions = 0;  // impacts at which r(v) left [0, 1] and was clamped
  long long undecided_touches = 0;     // grazings within rounding, passed without impact
  double stuck_time = 0.0;             // with at least one stop closed, s
  // By impacts that gained and that lost kinetic energy, and contacts that gave and took, from
  // surface to surface, J.
  double energy_added = 0.0;
  double energy_lost = 0.0;
  // Over the whole run and all stops, m: below zero by how deep a spring was compressed. Absent
  // without stops.
  std::optional<double> smallest_gap;
  double penetration = 0.0;  // of rigid stops, m: rounding, if anything
};

// Everything a run needs to go on as if it had never ended: where its last arc began.
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
  ContactBook contacts;             // per stop
  std::optional<ChatterTail> tail;  // of a chatter that was summed, until it is over
  RunTotals totals;
  bool keeps_book = false;
  EnergyBook book;
  long long samples = 0;       // handed out so far
  double closure_speed = 0.0;  // m/s
};

struct Simulation {
  RunOutcome outcome = RunOutcome::kReachedEnd;
  std::string message;  // a sentence unless the end was reached
  double end_time = 0.0;
  State final;
  std::vector<int> stuck;      // closed stops at the end (index from 0)
  std::vector<double> forces;  // contact forces at the end, N, one per stop
  RunTotals totals;
  std::optional<EnergyBook> energy;
  // Of gaps and contact forces in search of events, and of the equations of motion on springs; with
  // `steps` of the equations of motion alone.
  long long evaluations = 0;
  RunState state;  // to go on from
};

// Runs the system from `start` at t = 0. Requires forcing or a duration.
Simulation simulate(const System& system, const State& start, const SimulationOptions& options,
                    const RunListeners& listeners = {});

// Goes on from the state that an earlier run of the same system left behind; the events that follow
// are, bit for bit, those of a run that was never cut.
Simulation resume(const System& system, const RunState& from, const SimulationOptions& options,
                  const RunListeners& listeners = {});

}  // namespace graze
