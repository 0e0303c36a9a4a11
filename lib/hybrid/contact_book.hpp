// What is remembered of the contacts at compliant stops while they last.
#pragma once

#include <vector>

#include "graze/flow/contact_phase.hpp"

namespace graze {

struct SpringContact {
  double since = 0.0, speed = 0.0;  // s, m/s: where it began, and how fast
  double peak_force = 0.0;          // N, so far
  double taken = 0.0;               // from the structure, J, so far
};

// Per stop.
using ContactBook = std::vector<SpringContact>;

// Along the arc that the phase has flown, s.
void follow(ContactBook& book, const ContactPhase<double>& phase, double flight);

}  // namespace graze
