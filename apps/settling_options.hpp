// What the options ask of motions that are followed until they settle.
#pragma once

#include "command.hpp"
#include "graze/study/settled_row.hpp"

namespace graze {

inline void set_settling(const Command& command, RowOptions& options) {
  options.periods = command.periods.value_or(options.periods);
  options.samples = command.samples;
  options.exponent_periods = command.exponents;
  options.max_impacts = command.max_impacts;
  options.closure_speed = command.closure_speed;
}

}  // namespace graze
