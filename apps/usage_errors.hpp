// What is said of a command line that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "command_description.hpp"

namespace graze {

// A sentence about these words after the program's name, which the parser refused. `commands`: what
// is known of them.
std::string usage_sentence(const std::vector<std::string>& words, const CLI::App& app,
                           const std::vector<CommandDescription>& commands,
                           const CLI::ParseError& error);

// A sentence about an option without a value, as `--out "$FOLDER"` gives where nothing is in
// FOLDER, or "". Settings have their own sentence.
std::string empty_option(const CLI::App& command);

// A sentence about a word that is none of the program's commands.
std::string no_command(const std::string& word, const CLI::App& app);

}  // namespace graze
