// What a run counts of dry friction.
#pragma once

#include <algorithm>

#include "graze/motion/detail/motion.hpp"
#include "graze/motion/run_events.hpp"

namespace graze {

// The event of a friction that slips, reverses or begins to stick at the present instant.
inline Event friction_event(const Arrival<double>& arrival, const System& system,
                            Motion<double>& motion, RunTotals& totals) {
  const Instant<double>& now = motion.instant();
  const double force = motion.friction_force(arrival.stop);
  Event event{EventKind::kFrictionStick, seconds_at(now, motion.flow().period()), now.period, -1};
  event.friction = arrival.stop - static_cast<int>(system.stops.size());
  if (arrival.kind == ArrivalKind::kStick) {
    event.force = force;
    return event;
  }
  event.kind = arrival.kind == ArrivalKind::kSlip ? EventKind::kSlip : EventKind::kReversal;
  event.direction = force > 0.0 ? 1 : -1;
  ++(arrival.kind == ArrivalKind::kSlip ? totals.slips : totals.reversals);
  return event;
}

// Counts a flight during which all friction stuck.
inline void count_sticking(const ContactPhase<double>& phase, double flight, RunTotals& totals) {
  const std::vector<Contact>& frictions = phase.key().frictions;
  const auto sticks = [](Contact contact) { return contact == Contact::kClosed; };
  if (!frictions.empty() && std::all_of(frictions.begin(), frictions.end(), sticks))
    totals.sticking_time += flight;
}

}  // namespace graze
