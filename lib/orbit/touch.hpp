// Where periodic motion on compliant stops touches one at no speed, or comes near to that.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/orbit/passage_shooting.hpp"

namespace graze {

// An instant at which an orbit touches a compliant stop at no speed.
struct Touch {
  int stop = 0;
  std::size_t turn = 0;  // passage from section to section
  double angle = 0.0;    // of the forcing, after its start, rad, 0 <= angle < 2 pi
  // m/s: a contact at that instant which begins no faster is the touch itself, met a little deep.
  double slowest = 0.0;
};

// Where the orbit of a solution, or of one near that, comes near to a touch: its contacts, and the
// least gap of each of its turns, the nearest first, told by v^2/2 as the depth in units of the
// forced motion. Empty where there is neither, or where the motion cannot be followed.
std::vector<Touch> touches_near(const System& system, const PassageShooting& shooting,
                                const Vector& u);

// The first of them; nothing where there is none, or where that is a rigid stop's.
std::optional<Touch> nearest_touch(const System& system, const PassageShooting& shooting,
                                   const Vector& u);

}  // namespace graze
