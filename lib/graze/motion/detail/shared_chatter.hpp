// Chatter that several stops share: thrown off one, the structure meets another, ever more slowly,
// until all of them hold it.
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

// The largest speed that a stop is met at or left with, or would be met at after a fall under the
// force that will hold it, m/s.
double speed_left(const SharedChatter& chatter);

// How long it takes until the structure is at rest on all of them, s; nothing where an impact of
// more than `closure_speed` (m/s) is among those left, or where no end is in sight. Followed until
// a millionth of the speed is left; where that takes too many impacts, what is left of the time is
// judged by the part of the speed that has gone.
std::optional<double> time_to_rest(const SharedChatter& chatter, double closure_speed);

}  // namespace graze
