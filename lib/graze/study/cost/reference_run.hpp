// The motion in 50 digits, in closed form between impacts, by extrapolation to 24 digits a step in
// contacts with compliant stops (extended_contact.hpp): the reference for flows in double
// precision.
#pragma once

#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/system/system.hpp"

namespace graze {

// An impact, or the beginning or the end of a contact with a compliant stop.
struct ReferenceImpact {
  double time = 0.0;  // s
  int stop = 0;
  double speed = 0.0;   // of approach, at an end of leaving, m/s
  bool leaves = false;  // the end of a contact
};

struct ReferenceRun {
  std::vector<ReferenceImpact> impacts;
  double end_time = 0.0;  // s
  State end;              // there
  // For a motion without impacts: the states at the ends of equal parts of the run, sample_interval
  // apart, s.
  std::vector<State> samples;
  double sample_interval = 0.0;
  std::string message;  // why it ended early; else empty
};

struct ReferenceOptions {
  std::size_t impacts = 20;  // enough of them
  double slowest = 0.0;      // m/s; slower impacts, the tail of a chatter, are not recorded
  double longest = 0.0;      // s; the run ends here in any case
  StopSignal stop;
};

// Runs from `start` at t = 0 until there are enough impacts, and half the way to the next event; a
// motion without impacts until the end. A contact counts as one impact, and is followed to its end.
// Ends early, with a message, where only double precision can follow the motion.
ReferenceRun reference_run(const System& system, const State& start,
                           const ReferenceOptions& options);

// Whether there is no such run: of a structure on a hub, of modes that damping couples, of a stop
// whose law changes during a contact.
bool is_followed_by_steps(const System& system);

}  // namespace graze
