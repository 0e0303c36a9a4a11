// What a run tells where it ends.
#pragma once

#include <tuple>
#include <vector>

#include "graze/motion/detail/motion_walk.hpp"
#include "graze/motion/run_events.hpp"

namespace graze {

inline RunOutcome outcome_of(ArrivalKind failure) {
  return failure == ArrivalKind::kUndecided   ? RunOutcome::kEventBudget
         : failure == ArrivalKind::kNotFinite ? RunOutcome::kNotFinite
                                              : RunOutcome::kRefused;
}

// What holds the structure then: the stops that do, the forces of all stops, N, and all friction.
inline std::tuple<std::vector<int>, std::vector<double>, std::vector<AtFriction>> holders(
    const System& system, Motion<double>& motion, const MotionWalk<double>& walk,
    RunOutcome outcome) {
  // When the motion is refused at an instant, the forces are those before it.
  const bool known = !motion.has_pending_events() || outcome == RunOutcome::kRefused;
  std::vector<int> stuck;
  std::vector<double> forces;
  std::vector<AtFriction> frictions;
  const auto stops = static_cast<int>(system.stops.size());
  for (int i = 0; i < stops; ++i) {
    if (walk.is_stuck(i)) stuck.push_back(i);
    forces.push_back(known ? motion.contact_force(i) : 0.0);
  }
  for (int i = stops; i < stops + static_cast<int>(system.frictions.size()); ++i)
    frictions.push_back({motion.is_closed(i), known ? motion.friction_force(i) : 0.0});
  return {stuck, forces, frictions};
}

}  // namespace graze
