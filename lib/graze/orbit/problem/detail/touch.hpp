// Where periodic motion touches a stop at no speed, or comes near to that.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/orbit/problem/detail/passage_shooting.hpp"

namespace graze {

// An instant at which an orbit touches a stop at no speed.
struct Touch {
  int stop = 0;
  std::size_t turn = 0;  // passage from section to section
  double angle = 0.0;    // of the forcing, after its start, rad, up to the passage's end
  // m/s, of a compliant stop: a contact at that instant which begins no faster is the touch itself,
  // met a little deep.
  double slowest = 0.0;
};

// Where the orbit of a solution, or of one near that, comes near to a touch: its contacts, the
// slowest of its impacts outside chatters, and the least gap of each of its turns, the nearest
// first, told by v^2/2 as the depth in units of the forced motion. Empty where there is none of
// these, or where the motion cannot be followed.
std::vector<Touch> touches_near(const System& system, const PassageShooting& shooting,
                                const Vector& u);

// The motions of those passages that have one touch more or less besides: without the impact that
// it would be on a rigid stop, between the events before and after it. Nothing where they cannot be
// followed.
std::optional<PassageShooting> without_touch(const System& system, const PassageShooting& shooting,
                                             const Vector& u, const Touch& touch);

}  // namespace graze
