// Computing time of this process.
#pragma once

#include <functional>

#include "graze/base/stop_signal.hpp"

namespace graze {

// s, of all threads together, with the resolution of the clock in nanoseconds.
double processor_time();

// The least time that `work` takes, s. It is repeated until enough time for a measurement has
// passed and at least three times, but ends once all runs together took longer than `enough`; other
// load of the machine only adds to the time.
double least_time(const std::function<void()>& work, double enough, const StopSignal& stop = {});

}  // namespace graze
