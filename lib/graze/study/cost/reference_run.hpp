// The motion in 50 digits, in closed form between impacts, by extrapolation to 24 digits a step in
// contacts with compliant stops (extended_contact.hpp): what flows in double precision are compared
// with.
#pragma once

#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/system/system.hpp"

namespace graze {

// Or the beginning or the end of a contact with a compliant stop.
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
  // Without impacts: the states at the ends of equal parts of the run, sample_interval apart, s.
  std::vector<State> samples;
  double sample_interval = 0.0;
  std::string message;  // why it ended before what was asked for; else empty
};

struct ReferenceOptions {
  std::size_t impacts = 20;  // enough of them
  double slowest = 0.0;      // m/s; slower impacts, the tail of a chatter, are not told
  double longest = 0.0;      // s; the run ends here in any case
  StopSignal stop;
};

// From `start` at t = 0 until enough impacts were seen, and half the way to what comes next; a
// motion without impacts until the end. A contact counts as one impact, and is followed to its end.
// Ends early at what only double precision can follow, and says so.
ReferenceRun reference_run(const System& system, const State& start,
                           const ReferenceOptions& options);

}  // namespace graze
