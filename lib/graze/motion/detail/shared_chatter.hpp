// Chatter on several stops: thrown off one, the structure meets another, ever more slowly, until
// all of them hold it.
#pragma once

#include <optional>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/contact/restitution.hpp"

namespace graze {

// The motion of k contacts under constant pushes, one column or entry per stop.
struct SharedChatter {
  Matrix rows, directions;  // N x k, b and d
  Vector gaps;              // m, 0 where the stop is touched
  Vector speeds;            // approach speeds, m/s
  Vector pushes;            // accelerations into the stops while none of them is closed, m/s^2
  std::vector<Restitution> restitutions;
};

// The largest speed, m/s, at which a stop is met or left, or would be met after a fall under the
// force that will hold it.
double speed_left(const SharedChatter& chatter);

// Time until the structure is at rest on all of them, s. Returns nullopt when a later impact is
// faster than `closure_speed` (m/s), or when no end is in sight. The motion is followed until a
// millionth of the speed is left; where that takes too many impacts, the remaining time is
// extrapolated from the part of the speed that is gone.
std::optional<double> time_to_rest(const SharedChatter& chatter, double closure_speed);

}  // namespace graze
