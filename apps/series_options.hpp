// What the options ask of single runs over a parameter.
#pragma once

#include "command.hpp"
#include "graze/base/detail/even_values.hpp"
#include "graze/study/sweep/detail/run_series.hpp"
#include "session.hpp"

namespace graze {

// `duration`: of a run, s. `points`: values over the range.
inline RunSeriesOptions series_options(const MotionOptions& command, const RangeOptions& range,
                                       double duration, int points) {
  RunSeriesOptions options;
  options.parameter = range.parameter;
  options.values = even_values(range.from, range.to, points);
  options.duration = duration;
  options.closure_speed = command.closure_speed;
  options.max_impacts = command.max_impacts;
  options.threads = command.threads;
  options.stop = stop_signal(command);
  return options;
}

}  // namespace graze
