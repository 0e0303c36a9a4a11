// The program from its arguments to its exit code.
#pragma once

#include <functional>
#include <string>

#include "command.hpp"

namespace graze {

// Parses the arguments and calls `run`; returns the exit code, after a sentence on stderr where
// something could not be used, read or written. Sets what signals do.
int run_program(int argc, char** argv, const std::function<int(Command&)>& run);

// Does what the command says; returns the exit code.
int run_command(const Command& command);

// Returns what `work` returns, or, where it throws, what `on_error` does, called with a sentence
// and the exit code that the exception stands for.
int caught(const std::function<int()>& work,
           const std::function<int(const std::string& sentence, int code)>& on_error);

}  // namespace graze
