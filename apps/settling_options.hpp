// What the options ask of motions that are followed until they settle.
#pragma once

#include "command.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/study/sweep/settled_row.hpp"

namespace graze {

inline void set_settling(const MotionOptions& command, const SettlingOptions& settling,
                         RowOptions& options) {
  options.periods = settling.periods.value_or(options.periods);
  options.samples = settling.samples;
  options.exponent_periods = settling.exponents;
  options.max_impacts = command.max_impacts;
  options.closure_speed = command.closure_speed;
}

// What makes a difference to what they settle on.
inline void note_settling(const RowOptions& options, RunInfo& info) {
  info.options.emplace_back("periods", options.periods);
  info.options.emplace_back("samples", options.samples);
  if (options.exponent_periods > 0)
    info.options.emplace_back("exponents", options.exponent_periods);
  if (options.closure_speed) info.options.emplace_back("closure_speed", *options.closure_speed);
  info.options.emplace_back("max_impacts", options.max_impacts);
}

}  // namespace graze
