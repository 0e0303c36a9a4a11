// What lasts from event to event: contacts at compliant stops, the tail of a chatter.
#pragma once

#include <algorithm>
#include <vector>

#include "graze/flow/exact/instant.hpp"
#include "graze/motion/run_events.hpp"

namespace graze {

template <class Real>
class ContactPhase;

struct SpringContact {
  double since = 0.0, speed = 0.0;  // s, m/s: where it began, and how fast
  double peak_force = 0.0;          // N, so far
  double lost = 0.0;                // to the damping of the stop, J, so far
  double held = 0.0;                // by the spring when it began, J
  // Change of the structure's energy by the contacts since the surface that parted below it, J.
  double change_before = 0.0;
  // Change of the structure's energy by this contact, when the spring holds `stored`, J. For an
  // undamped spring it is exactly zero from surface to surface.
  double change(double stored) const { return held - stored - lost; }
};

// Tells by the event of a separation what the contact was, while the spring holds `stored`, J.
void end_contact(SpringContact& contact, double stored, Event& event);

// One for each stop.
using SpringContacts = std::vector<SpringContact>;

// Follows the contacts along the last arc of the phase, s. Returns the largest depth of a spring
// meanwhile, m; 0 where none was compressed.
double follow(SpringContacts& contacts, const ContactPhase<double>& phase, double flight);

// The tail of a chatter that was summed: the motion is at rest on its stops from the instant of the
// summation, but events report this only when the tail is over.
struct ChatterTail {
  std::vector<int> stops;  // ascending
  Instant<double> over;
  bool holds(int stop) const { return std::binary_search(stops.begin(), stops.end(), stop); }
};

}  // namespace graze
