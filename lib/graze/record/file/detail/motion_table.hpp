// The state of a motion as a table of a file that is read back to all its digits.
#pragma once

#include <string>

#include "graze/motion/detail/motion.hpp"
#include "graze/record/file/detail/state_lines.hpp"
#include "graze/record/file/detail/state_table.hpp"

namespace graze {

// `header`: "[motion]"
void write_motion(StateLines& lines, const std::string& header, const MotionState<double>& motion);

// Throws InputError where the table holds no state of `system`; `path` names it in messages.
MotionState<double> read_motion(const Node& node, const std::string& path, const System& system);

// From the keys period and local.
Instant<double> read_instant(const StateTable& table, const System& system);

}  // namespace graze
