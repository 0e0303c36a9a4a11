// What the options ask of single runs over a parameter.
#pragma once

#include "command.hpp"
#include "graze/base/detail/even_values.hpp"
#include "graze/study/sweep/detail/run_series.hpp"
#include "session.hpp"

namespace graze {

// `points`: values from A to B. Requires a duration.
inline RunSeriesOptions series_options(const Command& command, int points) {
  RunSeriesOptions options;
  options.parameter = command.parameter;
  options.values = even_values(command.from, command.to, points);
  options.duration = *command.duration;
  options.closure_speed = command.closure_speed;
  options.max_impacts = command.max_impacts;
  options.threads = command.threads;
  options.stop = stop_signal(command);
  return options;
}

}  // namespace graze
