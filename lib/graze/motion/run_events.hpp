// What a run reports: its events, single and in total, and its samples.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "graze/motion/energy_balance.hpp"
#include "graze/system/system.hpp"

namespace graze {

// kContact and kSeparation: at a compliant stop. The last three of dry friction.
enum class EventKind {
  kImpact,
  kChatter,
  kStick,
  kRelease,
  kContact,
  kSeparation,
  kSlip,
  kReversal,
  kFrictionStick
};

struct Event {
  EventKind kind = EventKind::kImpact;
  double time = 0.0;           // s
  long long period_index = 0;  // whole forcing periods before it
  int stop = 0;                // index from 0; -1 of friction
  // Impact: approach speed just before, m/s, > 0; forcing phase (frequency t + phase) mod 2 pi,
  // rad, absent without forcing; change of the kinetic energy, J.
  double speed = 0.0;
  std::optional<double> phase{};
  double energy_change = 0.0;
  // Chatter, at its last resolved impact: the number of impacts on this stop up to it that each
  // were slower than the one before, and the speed below which the rest was summed, m/s. Stops that
  // share a chatter are reported one by one; the energy stands with the one hit last (fastest).
  long long impacts = 0;
  double closure_speed = 0.0;
  // Stick: the contact force that sets in, N; of friction what it exerts along -u. Slip and
  // reversal: `direction` is the way it slides, 1 or -1.
  double force = 0.0;
  // Contact: speed and phase as for an impact. Separation: the speed away from the stop; the
  // duration of the contact, s; its largest force, N; its coefficient of restitution, absent where
  // it began at rest; and as energy change minus the energy that the stop took meanwhile.
  double duration = 0.0;
  double peak_force = 0.0;
  std::optional<double> effective_restitution{};
  int friction = -1;  // index from 0; -1 of stops
  int direction = 0;  // see `force`
};

struct RunTotals {
  long long impacts = 0;
  long long chatters = 0;              // summed, or followed down to rounding
  long long clamped_restitutions = 0;  // impacts at which r(v) left [0, 1] and was clamped
  long long undecided_touches = 0;     // grazings within rounding, passed without impact
  double stuck_time = 0.0;             // with at least one stop closed, s
  // Sums of the energy by impacts that gained and by those that lost kinetic energy, and by
  // contacts that gave and took energy, from surface to surface, J.
  double energy_added = 0.0;
  double energy_lost = 0.0;
  // Over the whole run and all stops, m; negative by the largest depth at a spring. Absent without
  // stops.
  std::optional<double> smallest_gap;
  double penetration = 0.0;  // of rigid stops, m: at most rounding
  long long slips = 0, reversals = 0;  // of dry friction
  double sticking_time = 0.0;          // of all dry friction at once, s
};

struct Sample {
  double time = 0.0;   // s
  State state;         // of the system; structure_state has that of its structure
  double phase = 0.0;  // of the forcing, rad; 0 without
  std::vector<double> forces;           // contact force at every stop, N; 0 where it is open
  std::optional<EnergyBalance> energy;  // up to this instant, when the run keeps the balance
  std::vector<double> frictions{};      // what every dry friction exerts along -u, N
};

enum class RunOutcome {
  kReachedEnd,
  kEventBudget,
  kTimeBudget,
  kNotFinite,
  kRefused,  // the motion on a stop cannot be followed: its law makes it grow without bound
  kInterrupted
};

// Of dry friction at the end of a run.
struct AtFriction {
  bool sticks = false;
  double force = 0.0;  // that it exerts along -u, N
};

// How many samples of a rate (1/s), counted from t = 0, come before a time (s).
inline long long samples_before(double time, double rate) {
  constexpr double kMost = 0x1p62;  // that can be counted
  return static_cast<long long>(std::fmin(std::ceil(time * rate), kMost));
}

// Callbacks that a run calls as it goes; an empty function is never called and costs nothing.
struct RunListeners {
  std::function<void(const Event&)> event;
  std::function<void(const Sample&)> sample;
  double sample_rate = 0.0;                       // 1/s, with `sample`
  double sample_from = 0.0;                       // s, of the first sample at the earliest
  std::function<void(double fraction)> progress;  // once per forcing period
};

}  // namespace graze
