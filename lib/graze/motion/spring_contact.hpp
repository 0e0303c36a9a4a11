// What is remembered of the contacts at compliant stops while they last.
#pragma once

#include <vector>

namespace graze {

template <class Real>
class ContactPhase;

struct SpringContact {
  double since = 0.0, speed = 0.0;  // s, m/s: where it began, and how fast
  double peak_force = 0.0;          // N, so far
  double lost = 0.0;                // to the damping of the stop, J, so far
  double held = 0.0;                // by the spring when it began, J
  // Of the structure's energy, by the contacts since the surface that parted below it, J.
  double change_before = 0.0;
  // Of the structure's energy by this one, when the spring holds `stored`, J. Where nothing damps
  // it is zero from surface to surface, without rounding.
  double change(double stored) const { return held - stored - lost; }
};

// Per stop.
using SpringContacts = std::vector<SpringContact>;

// Along the arc that the phase has flown, s. Returns by how much the deepest spring was compressed
// meanwhile, m; 0 where none was.
double follow(SpringContacts& contacts, const ContactPhase<double>& phase, double flight);

}  // namespace graze
