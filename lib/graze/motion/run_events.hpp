// The events of a run, single and in total.
#pragma once

#include <optional>

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
  // Chatter, at its last resolved impact: the number of impacts on this stop up to it that each
  // were slower than the one before, and the speed below which the rest was summed, m/s. Stops that
  // share a chatter are reported one by one; the energy stands with the one hit last (fastest).
  long long impacts = 0;
  double closure_speed = 0.0;
  // Stick: the contact force that sets in, N.
  double force = 0.0;
  // Contact: speed and phase as for an impact. Separation: the speed away from the stop; the
  // duration of the contact, s; its largest force, N; its coefficient of restitution, absent where
  // it began at rest; and as energy change minus the energy that the stop took meanwhile.
  double duration = 0.0;
  double peak_force = 0.0;
  std::optional<double> effective_restitution{};
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
};

}  // namespace graze
