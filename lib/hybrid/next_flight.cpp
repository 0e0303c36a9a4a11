#include "graze/hybrid/next_flight.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graze {

ChatterTail tail_of(const Motion<double>& motion, const ClosedChatter<double>& closed) {
  return {closed.stops, later(motion.instant(), closed.duration, motion.flow().period())};
}

NextFlight next_flight(const Motion<double>& motion, const Instant<double>& end,
                       const std::optional<ChatterTail>& tail, double longest) {
  const Instant<double>& now = motion.instant();
  NextFlight flight;
  flight.horizon = motion.flow().period();
  if (tail && tail->over.period == now.period)
    flight.horizon = std::min(flight.horizon, tail->over.local);
  if (flight.horizon - now.local > longest) flight.horizon = now.local + longest;
  flight.cut = now.period == end.period && end.local <= flight.horizon;
  flight.until = flight.cut ? end.local : flight.horizon;
  if (!std::isfinite(flight.horizon)) flight.horizon = flight.until;
  return flight;
}

std::string failure_of(const Motion<double>& motion, const Arrival<double>& arrival) {
  const bool at_stop = arrival.stop >= 0;
  switch (arrival.kind) {
    case ArrivalKind::kUndecided:
      return fmt::format("the search for the next event{} used up its evaluations",
                         at_stop ? fmt::format(" at stop {}", arrival.stop + 1) : "");
    case ArrivalKind::kNotFinite:
      return "the motion left the range of double precision";
    case ArrivalKind::kRefused:
      return fmt::format("the motion{} cannot be followed: {}",
                         at_stop ? fmt::format(" on stop {}", arrival.stop + 1) : "",
                         motion.refusal());
    case ArrivalKind::kTime:
    case ArrivalKind::kContact:
    case ArrivalKind::kTouch:
    case ArrivalKind::kStick:
    case ArrivalKind::kRelease:
    case ArrivalKind::kEntry:
    case ArrivalKind::kSeparation:
    case ArrivalKind::kLeft:
    case ArrivalKind::kJoint:
      break;
  }
  return "";
}

}  // namespace graze
