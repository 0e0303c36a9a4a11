// Definitions of motion.hpp: the first event of a motion that is integrated step by step.
#pragma once

#include <type_traits>

#include "graze/hybrid/motion.hpp"

namespace graze {

// By the signs at the ends of steps. A rigid stop that the structure cannot leave is touched at
// once.
template <class Real>
void Motion<Real>::search_by_steps(ContactPhase<Real>& phase, const Real& until,
                                   Arrival<Real>& arrival) {
  if constexpr (std::is_same_v<Real, double>) {
    // Two springs at one place: what enters the one leaves the other at the same instant.
    for (const int i : compliant_) {
      const bool compressed = contact(i) == Contact::kCompressed;
      if (!compressed && contact(i) != Contact::kParted) continue;
      if (depth(i) > 0.0 || !(approach_speed(i) < -speed_rounding(i))) continue;
      arrival = {compressed ? ArrivalKind::kSeparation : ArrivalKind::kLeft,
                 i,
                 0.0,
                 0.0,
                 0,
                 {},
                 false,
                 false};
      return;
    }
    std::vector<Watched> list;
    watch_springs(phase, list);
    for (const int i : all_) {
      const Contact at = contact(i);
      if (at == Contact::kLocked || at == Contact::kCompressed || at == Contact::kParted) continue;
      const Watch& watch = phase.watch(i, now_.multiplicities[static_cast<std::size_t>(i)]);
      if (watch.multiplicity > 0 && !(watch.departure > 0.0)) {
        arrival = {ArrivalKind::kTouch, i, 0.0, 0.0, 0, {}, false, false};
        return;
      }
      list.push_back(
          {i, &watch, at == Contact::kClosed ? ArrivalKind::kRelease : ArrivalKind::kContact});
    }
    watch_joint(phase, list);
    std::vector<const Watch*> watches;
    for (const Watched& watched : list) watches.push_back(watched.watch);
    const StepDescent found = phase.step_flow()->first_descent(
        watches, arrival.flight, until - now_.instant.local, stop_, told_depth_);
    arrival.evaluations = found.values;
    arrival.lowest = found.lowest;
    arrival.flight = found.s;
    if (!found.finite) arrival.kind = ArrivalKind::kNotFinite;
    if (found.stopped) {
      arrival.kind = ArrivalKind::kUndecided;
      arrival.flight = 0.0;
      arrival.stop = list.empty() ? -1 : list.front().stop;
      return;
    }
    if (found.watch < 0 || !found.finite) return;
    const Watched& met = list[static_cast<std::size_t>(found.watch)];
    arrival.stop = met.stop;
    arrival.kind = met.kind;
    arrival.below = met.below;
    arrival.forward = met.watch->factor < 0.0;
  }
}

}  // namespace graze
