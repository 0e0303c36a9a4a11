// What is said of a command line that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace graze {

// A sentence about a word that the command does not know, or "".
std::string unknown_option(const CLI::App& app);

// A sentence about an option without a value, as `--out "$FOLDER"` gives where nothing is in
// FOLDER, or "". Settings have their own sentence.
std::string empty_option(const CLI::App& command);

// A sentence about a first word that is no command, or "".
std::string unknown_command(int argc, char** argv, const CLI::App& app);

}  // namespace graze
