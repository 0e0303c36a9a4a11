// Computing time of this process.
#pragma once

#include <functional>

#include "graze/base/stop_signal.hpp"

namespace graze {

// s, of all threads together, to the clock's nanoseconds.
double processor_time();

// The least time that `work` takes, s: it is repeated until so many seconds have gone by and at
// least three times, unless it takes longer than `enough` altogether; what else the machine does
// only adds to it.
double least_time(const std::function<void()>& work, double enough, const StopSignal& stop = {});

}  // namespace graze
