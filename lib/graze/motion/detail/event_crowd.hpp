// The last events of a run: where they crowd together, which stops have how many. Reported when a
// run has spent its budget on them.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "graze/base/units.hpp"
#include "graze/motion/run_events.hpp"

namespace graze {

// "t = 6.5 s"
std::string moment_text(double time, Units units);

class EventCrowd {
 public:
  void add(const Event& event);
  // "; the last 512 events took 3.1e-05 s: stop 2, 140 impacts at 1e-9 to 2e-7 m/s, ..", the
  // busiest stops first. Empty when there are fewer events, or when they took a large part of
  // `span` (s): then they are ordinary motion.
  std::string sentence(double span, Units units) const;

 private:
  static constexpr std::size_t kKept = 512;
  struct Kept {
    EventKind kind = EventKind::kImpact;
    int stop = 0;
    double time = 0.0, speed = 0.0;  // s, m/s
  };
  std::array<Kept, kKept> last_{};  // in turn
  std::size_t count_ = 0;
};

}  // namespace graze
