// A command in the process of Python: done in a thread of its own while Python's main thread looks
// for Ctrl-C and tells how far the work is.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "command.hpp"
#include "found_result.hpp"

namespace graze {

// Does the command without the interpreter's lock. `progress`: called with a number from 0 to 1, or
// None. Throws what the command threw; an interrupt raises Python's own exception, with the
// attribute `result` where something was finished.
std::shared_ptr<FoundResult> run_in_process(Command command, const pybind11::object& progress);

}  // namespace graze
