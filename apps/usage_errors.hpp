// What is said of a command line that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace graze {

// A sentence about these words after the program's name, which the parser refused.
std::string usage_sentence(const std::vector<std::string>& words, const CLI::App& app,
                           const CLI::ParseError& error);

// A sentence about an option without a value, as `--out "$FOLDER"` gives where nothing is in
// FOLDER, or "". Settings have their own sentence.
std::string empty_option(const CLI::App& command);

// A sentence about a word that is none of the program's commands.
std::string no_command(const std::string& word, const CLI::App& app);

// An option as it is given, "--points N".
std::string with_placeholder(const CLI::Option& option);

// The words that an option takes, of a type "WHAT:{impact,stroboscopic}"; empty: any.
std::vector<std::string> choices_of(const CLI::Option& option);

}  // namespace graze
