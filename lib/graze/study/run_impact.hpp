// An impact of a run, or the beginning of a contact at a compliant stop, for tables.
#pragma once

#include "graze/motion/simulation.hpp"

namespace graze {

struct RunImpact {
  double time = 0.0;   // s
  int stop = 0;        // from 0
  double speed = 0.0;  // of approach, m/s; of a contact too
};

// A spring that grips again below the surface, on the way out, is no new contact.
inline bool meets_stop(const Event& event) {
  return event.kind == EventKind::kImpact ||
         (event.kind == EventKind::kContact && event.speed > 0.0);
}

}  // namespace graze
