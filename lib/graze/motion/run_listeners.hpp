// Callbacks of a run.
#pragma once

#include <functional>

#include "graze/motion/run_events.hpp"
#include "graze/motion/sample.hpp"

namespace graze {

// Callbacks that a run calls as it goes; an empty function is never called and costs nothing.
struct RunListeners {
  std::function<void(const Event&)> event;
  std::function<void(const Sample&)> sample;
  double sample_rate = 0.0;                       // 1/s, with `sample`
  double sample_from = 0.0;                       // s, of the first sample at the earliest
  std::function<void(double fraction)> progress;  // once per forcing period
};

}  // namespace graze
