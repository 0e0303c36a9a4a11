// Words as a shell takes them, for commands that are shown to be copied.
#pragma once

#include <string>
#include <vector>

namespace graze {

// The word, in quotes if a shell would interpret it.
std::string shell_word(const std::string& word);

// The program, already quoted for a shell, with these arguments.
std::string shell_command(const std::vector<std::string>& arguments,
                          const std::string& program = "graze");

}  // namespace graze
